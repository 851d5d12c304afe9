// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/growth/GrowCriteria.h"
#include "tests/support/cases/EngineConformance.h"

#include <bitset>
#include <optional>
#include <vector>

namespace test {

/// What a growth is asked before its kernels are chosen; each set of answers has kernels of its own
/// (gpu/kernels/growth/GrowthPrograms.h), which a software driver compiles for seconds.
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
    Overwritten, ///< labels that it takes from others are kept
};
constexpr std::size_t growthQuestions = 10;

/// The answers of a growth.
struct GrowthAnswers {
    int connectivity = 6;
    std::bitset<growthQuestions> yes{}; ///< by GrowthQuestion

    bool operator==(const GrowthAnswers&) const = default;
};

[[nodiscard]] GrowthAnswers answersOf(const core::GrowBurst& burst);
/// Of every growth of a case, in order. Once one keeps what it takes, those after it do so too.
[[nodiscard]] std::vector<GrowthAnswers> answersOf(const EngineCase& engineCase);

/// The answers that random growths give in a daily run: few. For any two questions, every pair of
/// answers is among the first (pairedAnswers) and those without any criterion.
[[nodiscard]] const std::vector<GrowthAnswers>& dailyAnswers();
constexpr std::size_t pairedAnswers = 8;

/// A case whose growths give daily answers, each those that are nearest to its own; in a long run
/// the case as it is.
/// @param first which of the paired answers its first growth gives instead, counted around
[[nodiscard]] EngineCase daily(EngineCase engineCase, std::optional<std::size_t> first = {});
/// The same for the criteria of an edit.
/// @param boxIfAsked, spacingMm from which a box and a passage are made where they need one
void answerAsDaily(core::GrowCriteria& criteria, const core::GrowBox& boxIfAsked, double spacingMm);

} // namespace test
