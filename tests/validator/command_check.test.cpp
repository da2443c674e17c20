// From the text of a command to its canonical form, or to what is wrong with it.
#include "validator/commands/command_check.hpp"

#include "support/catch.hpp"

#include <string>
#include <string_view>

namespace command_check_test {

namespace {

using namespace axisc;
using namespace axisc::validator;

CommandLimits limits(std::uint32_t microseconds = 1000, bool time_delay = false) {
  return {.cycle_time = {microseconds * 1000}, .time_delay = time_delay};
}

/// `AX5002 <ORDR>` for each mistake, or the command's parameters in canonical form.
std::string result(std::string_view text, CommandLimits const& limits = command_check_test::limits()) {
  CheckedCommand const checked = parse_filter_command(text, limits);
  std::string mistakes;
  for (CommandMistake const& mistake : checked.mistakes) {
    for (Language const language : {Language::english, Language::german}) {
      CHECK(render(mistake.message, language).find('{') == std::string::npos);
    }
    mistakes += code_text(mistake.code) + " <" +
                std::string(text.substr(mistake.span.begin, mistake.span.size())) + "> ";
  }
  if (!mistakes.empty()) return mistakes;
  REQUIRE(checked.command.has_value());
  return to_text(checked.command->parameters);
}

machine::FilterCommand command(std::string_view text) {
  CheckedCommand const checked = parse_filter_command(text, limits());
  REQUIRE(checked.mistakes.empty());
  REQUIRE(checked.command.has_value());
  return *checked.command;
}

std::string guard(std::string_view text) {
  auto const parsed = grammar::parse_nc_command(text);
  REQUIRE(parsed.has_value());
  CheckedCommand const checked = check_command(*parsed, text, limits(), Variables::accepted);
  std::string mistakes;
  for (CommandMistake const& mistake : checked.mistakes) {
    mistakes += code_text(mistake.code) + " <" +
                std::string(text.substr(mistake.span.begin, mistake.span.size())) + "> ";
  }
  return mistakes;
}

}  // namespace

TEST_CASE("the switch of a command") {
  CHECK(command("#FILTER ON").filter_switch == machine::FilterSwitch::on);
  CHECK(command("#FILTER OFF").filter_switch == machine::FilterSwitch::off);
  CHECK(command("#FILTER [ORDER=2]").filter_switch == machine::FilterSwitch::unchanged);
  CHECK(command("#FILTER ON[HSC]").hsc);
  CHECK_FALSE(command("#FILTER ON").hsc);
}

TEST_CASE("parameters in canonical form") {
  CHECK(result("#FILTER ON").empty());
  CHECK(result("#FILTER ON [SHARE=80 ORDER=020]") == "ORDER=20 SHARE=80");
  CHECK(result("#FILTER ON [ORDER=20.0 FCUT=99.5 QUALITY=.5]") == "ORDER=20 FCUT=99.5 QUALITY=0.5");
  CHECK(result("#FILTER ON [ORDER=0]") == "ORDER=0");
}

TEST_CASE("a time becomes the order that it means") {
  CHECK(result("#FILTER ON [ORDER_TIME=20000]") == "ORDER=20");
  CHECK(result("#FILTER ON [ORDER_TIME=20499]") == "ORDER=20");
  CHECK(result("#FILTER ON [ORDER_TIME=20500]") == "ORDER=21");
  CHECK(result("#FILTER ON [ORDER_TIME=20000]", limits(250)) == "ORDER=80");
  CHECK(result("#FILTER ON [ORDER_TIME=20000 ORDER=7]") == "ORDER=7");
  CHECK(result("#FILTER ON [ORDER_TIME=200000]") == "ORDER=200");
}

TEST_CASE("a time below one cycle is a mistake and switches the filter off") {
  CheckedCommand const checked = parse_filter_command("#FILTER ON [ORDER_TIME=999]", limits());
  REQUIRE(checked.mistakes.size() == 1);
  CHECK(checked.mistakes[0].depends_on_cycle_time);
  REQUIRE(checked.command.has_value());
  CHECK(checked.command->parameters.order == 0U);
}

TEST_CASE("what does not touch the kernel stands beside the parameters") {
  machine::FilterCommand const monitored = command("#FILTER ON [AX_DEV=0.001 ACC_FACT=2.5]");
  CHECK(monitored.parameters.empty());
  CHECK(monitored.tolerance == 0.001);
  CHECK(monitored.acceleration_factor == 2.5);
  CHECK_FALSE(command("#FILTER ON").tolerance);
  CHECK_FALSE(command("#FILTER ON").acceleration_factor);
}

TEST_CASE("ranges of #FILTER") {
  CHECK(result("#FILTER ON [ORDER=200]") == "ORDER=200");
  CHECK(result("#FILTER ON [ORDER=201]") == "AX5002 <201> ");
  CHECK(result("#FILTER ON [ORDER=-1]") == "AX5002 <-1> ");
  CHECK(result("#FILTER ON [ORDER=1.5]") == "AX5002 <1.5> ");
  CHECK(result("#FILTER ON [ORDER=1e999]") == "AX5002 <1e999> ");
  CHECK(result("#FILTER ON [ORDER=100]", limits(1000, true)) == "ORDER=100");
  CHECK(result("#FILTER ON [ORDER=101]", limits(1000, true)) == "AX5002 <101> ");
  CHECK(result("#FILTER ON [ORDER_TIME=1000]") == "ORDER=1");
  CHECK(result("#FILTER ON [ORDER_TIME=200001]") == "AX5002 <200001> ");
  CHECK(result("#FILTER ON [ORDER_TIME=100001]", limits(1000, true)) == "AX5002 <100001> ");
  CHECK(result("#FILTER ON [SHARE=0]") == "SHARE=0");
  CHECK(result("#FILTER ON [SHARE=100.5]") == "AX5002 <100.5> ");
  CHECK(result("#FILTER ON [AX_DEV=-0.001]") == "AX5002 <-0.001> ");
  CHECK(result("#FILTER ON [FCUT=1]") == "FCUT=1");
  CHECK(result("#FILTER ON [FCUT=0.9]") == "AX5002 <0.9> ");
  CHECK(result("#FILTER ON [FCUT=499.9]") == "FCUT=499.9");
  CHECK(result("#FILTER ON [FCUT=500]") == "AX5002 <500> ");
  CHECK(result("#FILTER ON [ACC_FACT=0.9]") == "AX5002 <0.9> ");
  CHECK(result("#FILTER ON [ACC_FACT=10]").empty());
  CHECK(result("#FILTER ON [ACC_FACT=10.1]") == "AX5002 <10.1> ");
  CHECK(result("#FILTER ON [QUALITY=1]") == "QUALITY=1");
  CHECK(result("#FILTER ON [QUALITY=0]") == "AX5002 <0> ");
  CHECK(result("#FILTER ON [QUALITY=1.01]") == "AX5002 <1.01> ");
}

TEST_CASE("keywords of #FILTER") {
  CHECK(result("#FILTER ON [ORDR=20]") == "AX5002 <ORDR> ");
  CHECK(result("#FILTER ON [order=20]") == "AX5002 <order> ");
  CHECK(result("#FILTER ON [MODE=1]") == "AX5002 <MODE> ");
  CHECK(result("#FILTER ON [ORDER=20 ORDER=30]") == "AX5002 <ORDER> ");
  CHECK(result("#FILTER ON [HSC ORDER=20 SHARE=80]") == "AX5002 <ORDER> ");
  CHECK(result("#FILTER ON [ORDER=20 HSC]") == "AX5002 <ORDER> ");
  CHECK(result("#FILTER ON [ORDER=V.P.ORDER]") == "AX5002 <V.P.ORDER> ");
  CHECK(parse_filter_command("#FILTER ON [ORDR=20]", limits()).mistakes[0].better == "ORDER");
}

TEST_CASE("syntax of #FILTER") {
  CHECK(result("") == "AX5001 <> ");
  CHECK(result("FILTER ON") == "AX5001 <FILTER ON> ");
  CHECK(result("#CALL AX [X]") == "AX5001 <#CALL AX> ");
  CHECK(result("#filter ON") == "AX5001 <#filter> ");
  CHECK(result("#FILTER on") == "AX5001 <on> ");
  CHECK(result("#FILTER ON ORDER=20") == "AX5001 <ORDER=20> ");
  CHECK(result("#FILTER ON [ORDER=20") == "AX5001 <[> ");
  CHECK(result("#FILTER ON [ORDER]") == "AX5001 <ORDER> ");
  CHECK(result("#FILTER ON [ORDER 20]") == "AX5001 <ORDER> ");
  CHECK(result("#FILTER ON [ORDER=]") == "AX5001 <ORDER> ");
  CHECK(result("#FILTER ON [ORDER=2O SHARE=0,5]") == "AX5001 <2O> AX5001 <0,5> ");
  CHECK(result("#FILTER ON [HSC=1]") == "AX5001 <HSC> ");
  CHECK(result("#FILTER ON [ORDR=20 SHARE=]") == "AX5002 <ORDR> AX5001 <SHARE> ");
}

TEST_CASE("#VIB GUARD") {
  CHECK(guard("#VIB GUARD ON [MODE=4 FREQ=1 DAMPING=0 AX_DEV=0 ACC_FACT=10]").empty());
  CHECK(guard("#VIB GUARD OFF").empty());
  CHECK(guard("#VIB GUARD ON [FREQ=P1]").empty());
  CHECK_FALSE(check_command(*grammar::parse_nc_command("#VIB GUARD ON [FREQ=P1]"), "#VIB GUARD ON [FREQ=P1]",
                            limits(), Variables::accepted)
                  .command);
  CHECK(guard("#VIB GUARD ON [FREQ=499.9]").empty());
  CHECK(guard("#VIB GUARD ON [FREQ=500]") == "AX5002 <500> ");
  CHECK(guard("#VIB GUARD ON [MODE=0 FREQ=0.5 DAMPING=1.1 AX_DEV=-1 ACC_FACT=0]") ==
        "AX5002 <0> AX5002 <0.5> AX5002 <1.1> AX5002 <-1> AX5002 <0> ");
  CHECK(guard("#VIB GUARD ON [DAMPING=1]") == "AX3026 <1> ");
  CHECK(guard("#VIB GUARD ON [MODE=2.5]") == "AX5002 <2.5> ");
  CHECK(guard("#VIB GUARD ON [ORDER=20 HSC]") == "AX5002 <ORDER> AX5002 <HSC> ");
  CHECK(guard("#VIB GUARD [ON]") == "AX5001 <[ON]> ");
}

TEST_CASE("a guard's parameters, and the tolerance that ends where it is not named") {
  auto const taken = [](std::string_view text) { return *parse_filter_command(text, limits()).command; };
  auto const command = taken("#VIB GUARD ON [MODE=2 FREQ=41.5 DAMPING=0.02 AX_DEV=0.01 ACC_FACT=2]");
  CHECK(command.parameters.guard);
  CHECK(command.parameters.order == 2U);
  CHECK(command.parameters.frequency->value == 41.5);
  CHECK(command.parameters.quality == 0.02);
  CHECK(command.tolerance == 0.01);
  CHECK(command.acceleration_factor == 2);
  CHECK(to_text(command.parameters) == "MODE=2 FREQ=41.5 DAMPING=0.02");
  CHECK(taken("#VIB GUARD [FREQ=35]").tolerance == 0);
  CHECK_FALSE(taken("#VIB GUARD OFF").tolerance);
  CHECK_FALSE(taken("#FILTER ON").tolerance);
  auto const later = parameters_after(command.parameters, taken("#VIB GUARD [FREQ=35]"));
  CHECK(to_text(later) == "MODE=2 FREQ=35 DAMPING=0.02");
  CHECK(to_text(parameters_after(command.parameters, taken("#FILTER [SHARE=80]"))) == "SHARE=80");
}

TEST_CASE("what is meant for ON or OFF is written so") {
  auto const better = [](std::string_view text) {
    return parse_filter_command(text, limits()).mistakes.at(0).better.value_or("");
  };
  CHECK(better("#filter on") == "#FILTER ON");
  CHECK(result("#filter  off") == "AX5001 <#filter  off> ");
  CHECK(better("#filter  off") == "#FILTER  OFF");
  CHECK(better("#filter Ein [ORDER=20]") == "#FILTER ON");
  CHECK(result("#filter on [ORDER=20]") == "AX5001 <#filter on> ");
  CHECK(better("#filter ON [ORDER=20]") == "#FILTER");
  CHECK(better("#filter one") == "#FILTER");
  CHECK(better("#FILTER EIN") == "ON");
  CHECK(better("#FILTER aus") == "OFF");
  CHECK(better("#FILTER [ON]") == "ON");
  CHECK(better("#FILTER [ off ]") == "OFF");
  CHECK(result("#FILTER [ON ORDER=20]") == "AX5001 <[ON > ");
  CHECK(better("#FILTER [ON ORDER=20]") == "ON [");
  CHECK(result("#FILTER [ON") == "AX5002 <ON> ");
  CHECK(better("#FILTER ON ON").empty());
}

TEST_CASE("whether a command gives an order") {
  auto const gives = [](std::string_view text) {
    return gives_order(*grammar::parse_nc_command(text), text);
  };
  CHECK(gives("#FILTER ON [ORDER=20]"));
  CHECK(gives("#FILTER [ORDER=1]"));
  CHECK(gives("#FILTER ON [ORDER_TIME=20000]"));
  CHECK(gives("#FILTER ON [ORDER=P1]"));
  CHECK(gives("#FILTER ON [ORDER=999 SHARE=]"));
  CHECK_FALSE(gives("#FILTER ON"));
  CHECK_FALSE(gives("#FILTER ON [ORDER=0 ORDER_TIME=20000]"));
  CHECK_FALSE(gives("#FILTER OFF [ORDER=20]"));
  CHECK_FALSE(gives("#FILTER ON [HSC]"));
  CHECK_FALSE(gives("#VIB GUARD ON [ORDER=20]"));
}

}  // namespace command_check_test
