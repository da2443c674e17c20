// The checks of AX1 and AX2, as the table names them.
#pragma once

#include "validator/rule.hpp"

namespace axisc::validator::checks {

void invalid_character(ListContext const& context, Report& report);              // AX1001
void expected_name(ListContext const& context, Report& report);                  // AX1002
void expected_value(ListContext const& context, Report& report);                 // AX1003
void malformed_index(ListContext const& context, Report& report);                // AX1004
void decimal_comma(ListContext const& context, Report& report);                  // AX1005
void malformed_number(ListContext const& context, Report& report);               // AX1006
void suspicious_trailer(ListContext const& context, Report& report);             // AX1007
void text_after_end(ListContext const& context, Report& report);                 // AX1008
void comment_in_string(ListContext const& context, Report& report);              // AX1009
void letter_case(ListContext const& context, Report& report);                    // AX1010
void comment_names_other_parameter(ListContext const& context, Report& report);  // AX1011
void unterminated_string(ListContext const& context, Report& report);            // AX1012

void unknown_parameter(ListContext const& context, Report& report);       // AX2001
void index_out_of_range(ListContext const& context, Report& report);      // AX2002
void wrong_type(ListContext const& context, Report& report);              // AX2003
void out_of_data_range(AxisContext const& context, Report& report);       // AX2004
void out_of_range(AxisContext const& context, Report& report);            // AX2005
void duplicate_parameter(ListContext const& context, Report& report);     // AX2006
void unknown_symbol(ListContext const& context, Report& report);          // AX2007
void string_too_long(ListContext const& context, Report& report);         // AX2008
void axis_type_mismatch(AxisContext const& context, Report& report);      // AX2009
void reference_unresolvable(AxisContext const& context, Report& report);  // AX2010
void reference_circular(AxisContext const& context, Report& report);      // AX2011
void reference_type(AxisContext const& context, Report& report);          // AX2012
void reference_index(AxisContext const& context, Report& report);         // AX2013
void reference_unit(AxisContext const& context, Report& report);          // AX2014
void limit_by_parameter(AxisContext const& context, Report& report);      // AX2015

void newer_than_build(AxisContext const& context, Report& report);  // AX2016

}  // namespace axisc::validator::checks
