// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/GrowthAnswers.h"

#include "tests/support/program/LongRun.h"

#include <algorithm>
#include <initializer_list>

namespace test {

namespace {

using core::GrowBurst;
using enum GrowthQuestion;

bool asks(const GrowthAnswers& answers, GrowthQuestion question)
{
    return answers.yes.test(std::size_t(question));
}

GrowthAnswers answering(int connectivity, std::initializer_list<GrowthQuestion> yes)
{
    GrowthAnswers answers{.connectivity = connectivity};
    for (const GrowthQuestion question : yes)
        answers.yes.set(std::size_t(question));
    return answers;
}

/// How much a growth changes if it gives other answers than its own.
std::size_t distance(const GrowthAnswers& a, const GrowthAnswers& b)
{
    return 2 * (a.yes ^ b.yes).count() + (a.connectivity == b.connectivity ? 0 : 1);
}

/// @param overwritten whether it must be one that keeps what it overwrites: kernels do so from the
/// first growth on that did
GrowthAnswers nearest(const GrowthAnswers& wanted, bool overwritten)
{
    const GrowthAnswers* best = nullptr;
    for (const GrowthAnswers& each : dailyAnswers()) {
        if (overwritten && !asks(each, Overwritten))
            continue;
        if (!best || distance(wanted, each) < distance(wanted, *best))
            best = &each;
    }
    return *best;
}

/// Gives an optional number, if it is wanted and not there; takes it, if it is not wanted.
template <class Number> void want(std::optional<Number>& number, bool wanted, Number otherwise)
{
    if (!wanted)
        number.reset();
    else if (!number)
        number = otherwise;
}

void give(GrowBurst& burst, const GrowthAnswers& answers, const glm::ivec3& size)
{
    const int some = burst.lowCode + 7 * burst.highCode; // differs from growth to growth
    core::GrowLimits& limits = burst.limits;
    burst.connectivity = answers.connectivity;
    want(limits.difference, asks(answers, Difference), 30 + some % 500);
    want(limits.gradient, asks(answers, Gradient), 30 + some % 700);
    want(limits.gradientDifference, asks(answers, GradientDifference), 30 + some % 600);
    if (limits.gradientWeights == glm::ivec3(0))
        limits.gradientWeights = {512, 700, 300};
    if (asks(answers, Majority) != (limits.majority > 1))
        limits.majority = asks(answers, Majority) ? 2 + some % 12 : some % 2;
    limits.smoothed = asks(answers, Smoothed);
    limits.onlyVisible = asks(answers, OnlyVisible);
    if (asks(answers, Boxed) && !limits.boxed) {
        limits.boxFrom = size / 9;
        limits.boxTo = size - 2;
    }
    limits.boxed = asks(answers, Boxed);
    if (asks(answers, Sigmas) != (limits.sigmas256 > 0))
        limits.sigmas256 = asks(answers, Sigmas) ? 200 + some % 1300 : 0;
    if (asks(answers, Passage) != core::isAsked(limits.passage))
        limits.passage = asks(answers, Passage)
            ? core::Passage{.spacing = glm::ivec3(16), .reach = 20 * 20}
            : core::Passage{};
    if (asks(answers, Passage)) {
        burst.tellsHeld = true;
        if (burst.opening == core::GrowOpening::Narrow)
            burst.opening = core::GrowOpening::Restart;
    }
}

/// After give(): what it may take from others.
void giveTaking(GrowBurst& burst, bool taking)
{
    if (!taking) {
        if (burst.tellsHeld) // else nothing is kept
            burst.overwritable.reset();
    } else if (!asks(answersOf(burst), Overwritten)) {
        burst.tellsHeld = true;
        burst.overwritable.set(2).set(3);
    }
}

/// The growth that a step opens, or opens anew.
GrowBurst* burstOf(EngineStep& step)
{
    if (auto* begin = std::get_if<BeginGrowth>(&step))
        return &begin->burst;
    auto* command = std::get_if<core::EngineCommand>(&step);
    if (auto* begin = command ? std::get_if<core::BeginEdit>(command) : nullptr)
        return std::get_if<GrowBurst>(&begin->edit);
    auto* extend = command ? std::get_if<core::ExtendEdit>(command) : nullptr;
    auto* anew = extend ? std::get_if<core::GrowAnew>(&extend->extension) : nullptr;
    return anew ? &anew->burst : nullptr;
}

} // namespace

GrowthAnswers answersOf(const GrowBurst& burst)
{
    const core::GrowLimits& limits = burst.limits;
    GrowthAnswers answers{.connectivity = burst.connectivity};
    const auto answer = [&answers](GrowthQuestion question, bool yes) {
        answers.yes.set(std::size_t(question), yes);
    };
    answer(Difference, limits.difference.has_value());
    answer(Gradient, limits.gradient.has_value());
    answer(GradientDifference, limits.gradientDifference.has_value());
    answer(Majority, limits.majority > 1); // the voxel itself is one
    answer(Smoothed, limits.smoothed);
    answer(OnlyVisible, limits.onlyVisible);
    answer(Boxed, limits.boxed);
    answer(Sigmas, limits.sigmas256 > 0);
    answer(Passage, core::isAsked(limits.passage));
    answer(Overwritten, burst.tellsHeld && burst.overwritable.any());
    return answers;
}

std::vector<GrowthAnswers> answersOf(const EngineCase& engineCase)
{
    std::vector<GrowthAnswers> all;
    std::bitset<256> keeping; // planes
    for (EngineStep step : engineCase.steps) {
        const GrowBurst* burst = burstOf(step);
        if (!burst)
            continue;
        GrowthAnswers answers = answersOf(*burst);
        if (asks(answers, Overwritten))
            keeping.set(burst->plane);
        answers.yes.set(std::size_t(Overwritten), keeping.test(burst->plane));
        all.push_back(answers);
    }
    return all;
}

const std::vector<GrowthAnswers>& dailyAnswers()
{
    // The first (pairedAnswers) were searched for: together with those without any criterion they
    // hold all pairs, and none holds many criteria, which would leave next to nothing to grow. The
    // others are those that named cases give anyway.
    static const std::vector<GrowthAnswers> answers{
        answering(18, {Difference, Gradient, Sigmas, Passage}),
        answering(18, {GradientDifference, Majority, OnlyVisible, Passage}),
        answering(6, {Difference, OnlyVisible, Boxed, Passage, Overwritten}),
        answering(18, {Smoothed, OnlyVisible, Boxed, Sigmas}),
        answering(26, {Difference, GradientDifference, Smoothed, Sigmas, Passage, Overwritten}),
        answering(26, {Gradient, Majority, OnlyVisible, Boxed, Overwritten}),
        answering(6, {Gradient, GradientDifference, Smoothed, Boxed}),
        answering(6, {Difference, Majority, Smoothed, Sigmas}),
        answering(6, {}),
        answering(18, {}),
        answering(26, {}),
        answering(6, {Overwritten}),
        answering(18, {Overwritten}),
        answering(26, {Overwritten}),
        answering(6, {Passage}),
        answering(18, {Passage}),
        answering(26, {Passage}),
        answering(6, {Sigmas}),
        answering(18, {Sigmas}),
        answering(26, {Sigmas}),
        answering(6, {Majority, Sigmas}),
        answering(26, {Majority, Sigmas}),
        answering(6, {Difference}),
        answering(6, {Gradient}),
        answering(18, {Gradient}),
        answering(26, {GradientDifference}),
        answering(26, {Gradient, GradientDifference}),
        answering(26, {Majority}),
        answering(6, {Smoothed}),
        answering(26, {Smoothed}),
        answering(6, {Smoothed, Sigmas}),
        answering(26, {Majority, Smoothed}),
        answering(6, {OnlyVisible}),
        answering(6, {Boxed}),
    };
    return answers;
}

EngineCase daily(EngineCase engineCase, std::optional<std::size_t> first)
{
    if (longRun())
        return engineCase;
    std::bitset<256> keeping; // planes
    for (EngineStep& step : engineCase.steps) {
        GrowBurst* burst = burstOf(step);
        if (!burst)
            continue;
        const GrowthAnswers given = first ? dailyAnswers()[*first % pairedAnswers]
                                          : nearest(answersOf(*burst), keeping.test(burst->plane));
        first.reset();
        give(*burst, given, engineCase.codes.size);
        // What others kept stays kept: then a growth need not take anything by itself.
        if (!keeping.test(burst->plane))
            giveTaking(*burst, asks(given, Overwritten));
        if (asks(given, Overwritten))
            keeping.set(burst->plane);
    }
    return engineCase;
}

void answerAsDaily(core::GrowCriteria& criteria, const core::GrowBox& boxIfAsked, double spacingMm)
{
    if (longRun())
        return;
    GrowthAnswers wanted{.connectivity = criteria.connectivity};
    const auto answer = [&wanted](GrowthQuestion question, bool yes) {
        wanted.yes.set(std::size_t(question), yes);
    };
    answer(Difference, criteria.difference.has_value());
    answer(Gradient, criteria.gradient.has_value());
    answer(GradientDifference, criteria.gradientDifference.has_value());
    answer(Majority, criteria.majority.value_or(0) > 1);
    answer(Smoothed, criteria.smoothing.value_or(false));
    answer(OnlyVisible, criteria.onlyVisible);
    answer(Boxed, criteria.box.has_value());
    answer(Sigmas, criteria.sigmas.has_value());
    answer(Passage, criteria.passage.has_value());
    answer(Overwritten, criteria.overwriteUnlocked);
    const GrowthAnswers given = nearest(wanted, false);
    criteria.connectivity = given.connectivity;
    want(criteria.difference, asks(given, Difference), 300.0);
    want(criteria.gradient, asks(given, Gradient), 300.0);
    want(criteria.gradientDifference, asks(given, GradientDifference), 300.0);
    if (asks(given, Majority) != (criteria.majority.value_or(0) > 1))
        criteria.majority = asks(given, Majority) ? std::optional(5) : std::nullopt;
    if (asks(given, Smoothed) != criteria.smoothing.value_or(false))
        criteria.smoothing = asks(given, Smoothed);
    criteria.onlyVisible = asks(given, OnlyVisible);
    want(criteria.box, asks(given, Boxed), boxIfAsked);
    want(criteria.sigmas, asks(given, Sigmas), 2.5);
    if (!criteria.sigmas)
        criteria.perStroke.reset();
    want(criteria.passage, asks(given, Passage), 2.5 * spacingMm);
    criteria.overwriteUnlocked = asks(given, Overwritten);
}

} // namespace test
