# One file per rule, named after it.

# Text, parameters and files: AX1, AX2, AX4020, AX9.
set(axisc_rules_text_and_parameter
  rules/table.cpp
)

# Filters and what was designed from them: AX3, AX6.
set(axisc_rules_filter
)
