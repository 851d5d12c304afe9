// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "tests/support/cases/EngineConformance.h"

#include <bitset>
#include <optional>
#include <vector>

namespace test {

/// The yes/no questions that choose the kernels of a growth. Each set of answers has kernels of its
/// own (gpu/kernels/growth/GrowthPrograms.h), and a software driver compiles them for seconds.
enum class GrowthQuestion {
    Difference,
    Gradient,
    GradientDifference,
    Majority,
    Smoothed,
    OnlyVisible,
    Boxed,
    Sigmas,
    Passage,
    Overwritten, ///< labels that it takes from other segments are kept
};
constexpr std::size_t growthQuestions = 10;

/// The answers that choose the kernels of a growth.
struct GrowthAnswers {
    int connectivity = 6;
    std::bitset<growthQuestions> yes{}; ///< by GrowthQuestion

    bool operator==(const GrowthAnswers&) const = default;
};

/// Returns the answers of a growth.
[[nodiscard]] GrowthAnswers answersOf(const core::GrowBurst& burst);
/// Returns the answers of every growth of a case, in order. After a growth that keeps what it
/// overwrites, all later ones of that plane do so, too.
[[nodiscard]] std::vector<GrowthAnswers> answersOf(const EngineCase& engineCase);

/// The few sets of answers that random growths give in a daily run. For any two questions, every
/// pair of answers occurs among the first pairedAnswers sets and those without any criterion.
[[nodiscard]] const std::vector<GrowthAnswers>& dailyAnswers();
constexpr std::size_t pairedAnswers = 8;

/// Returns a case whose growths are changed to daily answers: each to those nearest to its own. In
/// a long run the case stays as it is.
/// @param first index, modulo pairedAnswers, of the answers that its first growth gets instead
[[nodiscard]] EngineCase daily(EngineCase engineCase, std::optional<std::size_t> first = {});
/// The same for the criteria of an edit.
/// @param boxIfAsked the box, if the answers need one that the criteria do not have
/// @param spacingMm from which the width of a passage is computed, if the answers need one
void answerAsDaily(core::GrowCriteria& criteria, const core::GrowBox& boxIfAsked, double spacingMm);

} // namespace test
