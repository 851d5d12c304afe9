// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

void addGrowthStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::Document& document = scene.document;
    const core::LoadedVolume& volume = scene.volume;
    const core::Edit& first = scene.first;
    const core::Edit& second = scene.second;
    const core::Edit& seeds = scene.seeds;
    const core::Edit& others = scene.others;
    const core::Edit& lock = scene.lock;
    const core::Edit& some = scene.some;
    const core::Edit& all = scene.all;
    const core::Edit& none = scene.none;
    const core::Edit& over = scene.over;
    const core::Edit& drill = scene.drill;
    const glm::ivec3& size = scene.document.volumes.front().geometry.size;

    cases.push_back({"add a segment", volume, {}, first});
    cases.push_back({"rename a segment", volume, {first},
        core::ChangeSegment{.segment = 1, .name = QStringLiteral("Other"), .rgb = {}, .code = {}}});
    cases.push_back({"lock a segment", volume, {first}, lock});
    cases.push_back(
        {"move a segment", volume, {first, second}, core::MoveSegment{.segment = 1, .place = 2}});
    cases.push_back(
        {"growth beside a locked one", volume, {first, seeds, some, second, others, lock}, over});
    cases.push_back({"seeds", volume, {first}, seeds});
    cases.push_back({"seeds beside seeds", volume, {first, second, seeds}, others});
    core::SeedStroke moved = others.get<core::SeedStroke>();
    moved.segment = 1;
    moved.takenLps = seeds.get<core::SeedStroke>().pointsLps;
    core::SeedStroke taken{1, {}};
    taken.takenLps = {moved.takenLps->front()};
    cases.push_back({"seeds taken away", volume, {first, seeds}, taken});
    cases.push_back({"seeds moved", volume, {first, second, seeds, others}, moved});
    cases.push_back(
        {"seeds that have grown are not taken away", volume, {first, seeds, some}, taken});
    cases.push_back(
        {"growth from seeds that were moved", volume, {first, seeds, moved, taken}, some});
    cases.push_back({"growth in steps", volume, {first, seeds}, some});
    cases.push_back({"growth to closure", volume, {first, seeds, some}, all});
    cases.push_back({"growth of nothing", volume, {first, seeds}, none});
    cases.push_back({"growth of two", volume, {first, seeds, second, others, some}, all});
    cases.push_back({"growth over another", volume, {first, seeds, all, second, others}, over});
    const core::ShrinkSteps three{.steps = 3};
    cases.push_back({"shrinking", volume, {first, seeds, some, all}, three});
    cases.push_back({"shrinking to the seeds", volume, {first, seeds, some}, core::ShrinkSteps{}});
    cases.push_back({"shrinking two", volume, {first, seeds, some, second, others, over}, three});
    cases.push_back({"shrinking beside a locked one", volume,
        {first, seeds, some, second, others, all, lock}, core::ShrinkSteps{.steps = 1}});
    cases.push_back({"shrinking of nothing", volume, {first, seeds}, three});
    const core::ShrinkAt here{
        .pointsLps = others.get<core::SeedStroke>().pointsLps, .onlyHere = false};
    core::ShrinkAt onlyHere = here;
    onlyHere.onlyHere = true;
    core::ShrinkAt openCut = here;
    openCut.barrier = false;
    core::ShrinkAt back = here;
    back.steps = 2;
    core::ShrinkAt openBack = openCut;
    openBack.steps = 4;
    // Seeds themselves are never taken back.
    core::ShrinkAt besideSeeds = here;
    for (glm::dvec3& point : besideSeeds.pointsLps) {
        glm::dvec3 voxel = glm::round(document.volumes.front().geometry.toIndex(point));
        voxel.x += voxel.x + 1.0 < size.x ? 1.0 : -1.0;
        point = document.volumes.front().geometry.toWorld(voxel);
    }
    const core::PlugLeak plug{.pointLps = here.pointsLps.front()};
    auto guarded = over.get<core::GrowSteps>();
    guarded.guard = {.factor = 1.5, .voxels = 4, .generations = 6};
    cases.push_back({"shrinking here", volume, {first, seeds, over}, here});
    cases.push_back({"shrinking only here", volume, {first, seeds, over}, onlyHere});
    cases.push_back({"shrinking here, cut left open", volume, {first, seeds, over}, openCut});
    cases.push_back({"shrinking here by generations", volume, {first, seeds, over}, back});
    cases.push_back(
        {"shrinking here by generations, left open", volume, {first, seeds, over}, openBack});
    cases.push_back({"shrinking beside a locked one, here", volume,
        {first, seeds, some, second, others, all, lock}, besideSeeds});
    cases.push_back({"plugging where nothing is narrow", volume, {first, seeds, over}, plug});
    cases.push_back({"growth after an open cut", volume, {first, seeds, over, openCut}, over});
    cases.push_back({"growth after a shut cut", volume, {first, seeds, over, here}, over});
    cases.push_back({"growth with a guard", volume, {first, seeds}, guarded});
    cases.push_back({"growth with a guard, again", volume, {first, seeds, guarded}, guarded});
    cases.push_back({"growth after shrinking", volume, {first, seeds, all, three}, over});
    cases.push_back(
        {"undo only a shrinking", volume, {first, seeds, all, three, drill}, revertRows({4})});
    const auto interval = [](double lower, double upper) {
        core::ChangeInterval change;
        change.criteria.lower = lower;
        change.criteria.upper = upper;
        return change;
    };
    // Two strokes of a segment, each with statistics of its own.
    core::GrowSteps byStroke{
        .criteria = {.lower = 0, .upper = 1000, .sigmas = 0.75, .perStroke = true}, .steps = 4};
    core::SeedStroke more = others.get<core::SeedStroke>();
    more.segment = 1;
    cases.push_back({"growth by strokes", volume, {first, seeds, more}, byStroke});
    cases.push_back({"growth by strokes of two", volume,
        {first, second, seeds, moved, others, more}, byStroke});
    cases.push_back(
        {"another interval by strokes", volume, {first, seeds, more, byStroke}, interval(0, 700)});
    cases.push_back(
        {"resume by strokes", volume, {first, seeds, byStroke, more}, core::ResumeGrowth{}});
    auto rolling = over.get<core::GrowSteps>();
    rolling.criteria.passage = 2.5 * document.volumes.front().geometry.spacingMm().x;
    cases.push_back({"growth through passages of a width", volume, {first, seeds}, rolling});
    cases.push_back({"growth of two through passages of a width", volume,
        {first, seeds, second, others}, rolling});
    cases.push_back({"passages after growth without", volume, {first, seeds, some}, rolling});
    cases.push_back(
        {"interval through passages", volume, {first, seeds, rolling}, interval(0, 700)});
    cases.push_back({"shrinking what passed", volume, {first, seeds, rolling}, three});
    cases.push_back({"cutting what passed", volume, {first, seeds, rolling}, here});
    cases.push_back({"resume through passages", volume,
        {first, seeds, rolling, core::ShrinkSteps{.steps = 2}, second, others},
        core::ResumeGrowth{}});
    auto smoothed = over.get<core::GrowSteps>();
    smoothed.criteria.smoothing = true;
    cases.push_back({"growth by medians", volume, {first, seeds}, smoothed});
    cases.push_back({"interval over medians", volume, {first, seeds, smoothed}, interval(0, 700)});
    cases.push_back({"resume by medians", volume,
        {first, seeds, smoothed, core::ShrinkSteps{.steps = 2}}, core::ResumeGrowth{}});
    core::ChangeInterval fewSteps = interval(0, 900);
    fewSteps.steps = 3;
    core::ChangeInterval anew = interval(100, 900);
    anew.fromSeeds = true;
    cases.push_back({"wider", volume, {first, seeds, all}, interval(0, 900)});
    cases.push_back({"wider, some steps", volume, {first, seeds, all}, fewSteps});
    cases.push_back({"narrower", volume, {first, seeds, over}, interval(0, 240)});
    cases.push_back(
        {"narrower and wider", volume, {first, seeds, all, interval(100, 600)}, interval(50, 300)});
    cases.push_back({"nothing is left", volume, {first, seeds, all}, interval(60000, 60001)});
    core::ChangeInterval byItself = interval(0, 900);
    byItself.asBefore = false;
    cases.push_back({"seeds that wait come in", volume, {first, seeds}, byItself});
    cases.push_back(
        {"wider, two compete", volume, {first, seeds, second, others, some}, interval(0, 900)});
    cases.push_back({"wider beside a locked one", volume,
        {first, seeds, some, second, others, all, lock}, interval(0, 900)});
    cases.push_back({"anew from the seeds", volume, {first, seeds, all}, anew});
    cases.push_back({"resume", volume, {first, seeds, some}, core::ResumeGrowth{.steps = 4}});
    cases.push_back({"resume after another interval", volume,
        {first, seeds, some, fewSteps, core::ShrinkSteps{.steps = 2}}, core::ResumeGrowth{}});
    cases.push_back({"undo only a change of the interval", volume,
        {first, seeds, all, interval(0, 900), drill}, revertRows({4})});
    core::BarrierStroke shut;
    shut.path.radiusMm = 5.0;
    shut.path.pointsLps = {document.volumes.front().geometry.toWorld({4.0, 9.0, 9.0}),
        document.volumes.front().geometry.toWorld({20.0, 16.0, 12.0}),
        document.volumes.front().geometry.toWorld({30.0, 30.0, 12.0})};
    core::BarrierStroke opened = shut;
    opened.erase = true;
    opened.path.radiusMm = 6.0;
    cases.push_back({"barrier", volume, {first, seeds}, shut});
    cases.push_back({"barrier on what has grown", volume, {first, seeds, over}, shut});
    cases.push_back({"growth beside a barrier", volume, {first, seeds, shut}, over});
    cases.push_back({"barrier opened", volume, {first, seeds, shut, over}, opened});
    cases.push_back({"growth through an opened barrier", volume, {first, seeds, shut, over, opened},
        core::ResumeGrowth{}});
    cases.push_back(
        {"interval beside a barrier", volume, {first, seeds, over, shut}, interval(0, 800)});
}

} // namespace test
