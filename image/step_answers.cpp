#include "image/step_answers.hpp"

#include <numeric>
#include <utility>
#include <variant>

namespace axisc::image {

ChainFigures const& StepAnswers::figures(std::size_t axis) {
  if (figures_.empty()) {
    std::vector<std::size_t> all(contents_->axes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    figures_ = chain_figures(image_, *contents_, all);
  }
  return figures_[axis];
}

bool StepAnswers::starts() {
  if (host_) return true;
  auto created = RuntimeHost::create(image_);
  if (!std::holds_alternative<RuntimeHost>(created)) return false;
  host_ = std::get<RuntimeHost>(std::move(created));
  static_cast<void>(host_->reset_all(0));
  answers_.resize(contents_->axes.size());
  return true;
}

std::span<double const> StepAnswers::answer(std::size_t axis, std::uint64_t cycles) {
  if (!starts()) return {};
  std::vector<double> const setpoints(answers_.size(), 1);
  std::vector<double> filtered(setpoints.size());
  for (; cycles_ < cycles; ++cycles_) {
    static_cast<void>(host_->step(setpoints, filtered));
    for (std::size_t i = 0; i < filtered.size(); ++i) answers_[i].push_back(filtered[i]);
  }
  return std::span<double const>(answers_[axis]).first(cycles);
}

}  // namespace axisc::image
