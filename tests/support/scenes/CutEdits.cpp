// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/CutEdits.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"

namespace test {

namespace {

template <class Word, class Field> void say(const std::optional<Word>& word, Field& field)
{
    if (word)
        field = *word;
}

/// What all cuts have.
template <class Cut> void sayOfCut(const CutWords& words, Cut& cut)
{
    say(words.layer, cut.layer);
    say(words.view, cut.view);
    say(words.depthMm, cut.depthMm);
    say(words.surfaceThreshold, cut.surfaceThreshold);
    if constexpr (requires { cut.throughGaps; })
        say(words.throughGaps, cut.throughGaps);
    say(words.restore, cut.restore);
    say(words.hidden, cut.hidden);
    say(words.protectedSegments, cut.protectedSegments);
}

template <class Stroke> Stroke strokeWith(const CutWords& words, Stroke stroke)
{
    sayOfCut(words, stroke);
    say(words.mask, stroke.mask);
    say(words.radiusMm, stroke.mask.radiusMm);
    say(words.mode, stroke.mode);
    say(words.samples, stroke.samples);
    return stroke;
}

template <class Stroke> StrokeFacts factsOf(const Stroke& stroke)
{
    return {.view = stroke.view,
        .mask = stroke.mask,
        .depthMm = stroke.depthMm,
        .surfaceThreshold = stroke.surfaceThreshold,
        .restore = stroke.restore,
        .byTime = stroke.byTime,
        .samples = stroke.samples,
        .hidden = stroke.hidden,
        .protectedSegments = stroke.protectedSegments};
}

} // namespace

core::Edit drillWith(const CutWords& words)
{
    return strokeWith(words, core::DrillStroke{});
}

core::Edit drillWith(const CutWords& words, const core::Edit& drill)
{
    return strokeWith(words, drill.get<core::DrillStroke>());
}

core::Edit laserWith(const CutWords& words)
{
    return strokeWith(words, core::LaserStroke{});
}

core::Edit peelWith(const CutWords& words, const std::vector<glm::dvec2>& polygonMm)
{
    core::PeelCut peel{.polygonMm = polygonMm};
    sayOfCut(words, peel);
    return peel;
}

core::Edit scissorsWith(const CutWords& words, const std::vector<glm::dvec2>& polygonMm)
{
    core::ScissorsCut scissors{.polygonMm = polygonMm};
    sayOfCut(words, scissors);
    return scissors;
}

core::Edit begunStroke(const core::Edit& stroke)
{
    core::Edit begun = stroke;
    core::penSamplesOf(begun)->clear();
    return begun;
}

StrokeFacts factsOfStroke(const core::Edit& stroke)
{
    if (const auto* laser = stroke.as<core::LaserStroke>())
        return factsOf(*laser);
    return factsOf(stroke.get<core::DrillStroke>());
}

} // namespace test
