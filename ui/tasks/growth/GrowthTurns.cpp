// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/GrowthTurns.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowGuard.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/EditSession.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace ui {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(GrowthTurns)
};

bool haveSameInterval(const SeededSegment& a, const SeededSegment& b)
{
    return a.lower == b.lower && a.upper == b.upper;
}

/// Whether two intervals have at least half of their union in common.
bool compete(const SeededSegment& a, const SeededSegment& b)
{
    const double common = std::min(a.upper, b.upper) - std::max(a.lower, b.lower);
    const double all = std::max(a.upper, b.upper) - std::min(a.lower, b.lower);
    return 2.0 * common >= all;
}

/// Whether at least half of a turn's interval lies in that of a wider one.
bool liesIn(const GrowthTurn& turn, const GrowthTurn& wider)
{
    const double width = turn.upper - turn.lower;
    const double common = std::min(turn.upper, wider.upper) - std::max(turn.lower, wider.lower);
    return width < wider.upper - wider.lower && 2.0 * common >= width;
}

bool holds(const std::optional<std::vector<int>>& segments, int label)
{
    return segments && std::find(segments->begin(), segments->end(), label) != segments->end();
}

/// @param together other than an empty list
GrowthTurn turnOf(const std::vector<SeededSegment>& together)
{
    GrowthTurn turn{.segments = std::vector<int>(),
        .lower = together.front().lower,
        .upper = together.front().upper};
    for (const SeededSegment& segment : together) {
        turn.segments->push_back(segment.label);
        turn.lower = std::min(turn.lower, segment.lower);
        turn.upper = std::max(turn.upper, segment.upper);
    }
    std::sort(turn.segments->begin(), turn.segments->end());
    return turn;
}

/// All with seeds that are not locked; the active one has the interval that the panel shows.
std::vector<SeededSegment> seededSegments(const Workspace& workspace)
{
    std::vector<SeededSegment> seeded;
    const core::EditSession& session = *workspace.session();
    const GrowSettings& settings = workspace.growSettings();
    const std::bitset<256>& growing =
        workspace.seeds().past().of(session, workspace.growthPlane()).growing;
    for (const core::Segment& segment : session.document().segments) {
        if (!growing.test(std::size_t(segment.label)))
            continue;
        SeededSegment each{.label = segment.label,
            .lower = settings.lower,
            .upper = settings.upper,
            .isFresh = segment.voxels == 0};
        const auto known = workspace.seeds().intervals().of(segment.label);
        if (known && segment.label != workspace.activeSegment()) {
            each.lower = known->lower;
            each.upper = known->upper;
        }
        seeded.push_back(each);
    }
    return seeded;
}

QString namesOf(const GrowthTurn& turn, const core::Document& document)
{
    QStringList names;
    for (const int label : *turn.segments) {
        const core::Segment* segment = document.segment(label);
        names += segment ? segment->name : QString::number(label);
    }
    return names.join(Texts::tr(" and "));
}

} // namespace

std::vector<GrowthTurn> growthTurns(const std::vector<SeededSegment>& seeded, int active,
    const std::optional<std::vector<int>>& last)
{
    if (seeded.empty())
        return {};
    auto first = std::find_if(seeded.begin(), seeded.end(),
        [active](const SeededSegment& each) { return each.label == active; });
    if (first == seeded.end())
        first = std::find_if(
            seeded.begin(), seeded.end(), [](const SeededSegment& each) { return each.isFresh; });
    if (first == seeded.end())
        first = seeded.begin();
    if (std::all_of(seeded.begin(), seeded.end(),
            [&first](const SeededSegment& each) { return haveSameInterval(each, *first); }))
        return {{.lower = first->lower, .upper = first->upper}};

    std::vector<SeededSegment> waiting{*first};
    for (const SeededSegment& each : seeded) {
        const bool goesOn = !first->isFresh && holds(last, first->label) && holds(last, each.label);
        if (each.label != first->label
            && (each.isFresh || goesOn || haveSameInterval(each, *first)))
            waiting.push_back(each);
    }
    std::vector<GrowthTurn> turns;
    while (!waiting.empty()) {
        const SeededSegment leader = waiting.front();
        const auto rest = std::stable_partition(
            waiting.begin(), waiting.end(), [&leader](const SeededSegment& each) {
                return each.label == leader.label || compete(each, leader);
            });
        const GrowthTurn turn = turnOf({waiting.begin(), rest});
        turns.insert(std::find_if(turns.begin(), turns.end(),
                         [&turn](const GrowthTurn& other) { return liesIn(turn, other); }),
            turn);
        waiting.erase(waiting.begin(), rest);
    }
    return turns;
}

std::vector<GrowthTurn> growthTurns(const Workspace& workspace)
{
    std::vector<GrowthTurn> turns;
    if (const core::EditSession* session = workspace.session()) {
        const auto& criteria =
            workspace.seeds().past().of(*session, workspace.growthPlane()).criteria;
        turns = growthTurns(seededSegments(workspace), workspace.activeSegment(),
            criteria ? criteria->segments : std::nullopt);
    }
    const GrowSettings& settings = workspace.growSettings();
    if (turns.empty())
        turns.push_back({.lower = settings.lower, .upper = settings.upper});
    for (GrowthTurn& turn : turns)
        turn.plane = core::namedPlane(workspace.growthPlane());
    return turns;
}

core::GrowSteps growthOf(const GrowthTurn& turn, const Workspace& workspace)
{
    core::GrowSteps edit = growthOf(workspace.growSettings());
    edit.criteria.lower = turn.lower;
    edit.criteria.upper = turn.upper;
    edit.criteria.segments = turn.segments;
    edit.criteria.plane = turn.plane;
    edit.criteria.editable = workspace.editableRange();
    raiseGuard(edit.guard, turn.segments, core::growthPlaneOf(turn.plane), workspace);
    return edit;
}

std::vector<int> growingLabels(
    const std::optional<std::vector<int>>& segments, std::uint8_t plane, const Workspace& workspace)
{
    if (segments || !workspace.session())
        return segments.value_or(std::vector<int>());
    const std::bitset<256>& growing =
        workspace.seeds().past().of(*workspace.session(), plane).growing;
    std::vector<int> labels;
    for (std::size_t label = 0; label < growing.size(); ++label) {
        if (growing.test(label))
            labels.push_back(int(label));
    }
    return labels;
}

void raiseGuard(core::GrowGuard& guard, const std::optional<std::vector<int>>& segments,
    std::uint8_t plane, const Workspace& workspace)
{
    const AcceptedFronts& accepted = workspace.seeds().acceptedFronts();
    if (!accepted.isEmpty() && guard.factor && !guard.countsVoxels())
        guard.areaMm2 =
            std::max(guard.areaMm2, accepted.areaMm2(growingLabels(segments, plane, workspace)));
}

std::optional<double> raisedAreaMm2(const Workspace& workspace)
{
    if (!workspace.session() || !workspace.growSettings().guard.on
        || workspace.seeds().acceptedFronts().isEmpty())
        return std::nullopt;
    for (const GrowthTurn& turn : growthTurns(workspace)) {
        if (!activeGrows(turn, workspace))
            continue;
        const double areaMm2 = growthOf(turn, workspace).guard.areaMm2;
        return areaMm2 > workspace.growSettings().guardAreaMm2 ? std::optional(areaMm2)
                                                               : std::nullopt;
    }
    return std::nullopt;
}

std::optional<std::vector<int>> followingSegments(const Workspace& workspace)
{
    const core::EditSession& session = *workspace.session();
    const int active = workspace.activeSegment();
    const auto& criteria = workspace.seeds().past().of(session, workspace.growthPlane()).criteria;
    if (!criteria)
        return std::nullopt;
    const std::vector<SeededSegment> seeded = seededSegments(workspace);
    if (holds(criteria->segments, active)) {
        // Who is gone or locked by now rests.
        std::vector<int> left;
        for (const SeededSegment& each : seeded) {
            if (holds(criteria->segments, each.label))
                left.push_back(each.label);
        }
        return left;
    }
    const bool grewTogether = !criteria->segments
        && std::all_of(seeded.begin(), seeded.end(), [&](const SeededSegment& each) {
               return each.label == active
                   || (!each.isFresh && each.lower == criteria->lower
                       && each.upper == criteria->upper);
           });
    const bool known = std::any_of(seeded.begin(), seeded.end(),
        [active](const SeededSegment& each) { return each.label == active; });
    if (grewTogether || !known)
        return criteria->segments;
    return std::vector<int>{active};
}

void shareInterval(Workspace& workspace)
{
    const auto following = followingSegments(workspace);
    const GrowSettings& settings = workspace.growSettings();
    for (const SeededSegment& each : seededSegments(workspace)) {
        if (each.label == workspace.activeSegment() || (following && !holds(following, each.label)))
            continue;
        workspace.seeds().intervals().setByHand(each.label, settings.lower, settings.upper);
    }
}

bool activeGrows(const GrowthTurn& turn, const Workspace& workspace)
{
    return core::growthPlaneOf(turn.plane) == workspace.growthPlane()
        && (!turn.segments || holds(turn.segments, workspace.activeSegment()));
}

int grownIn(const GrowthTurn& turn, const Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    const int active = workspace.activeSegment();
    if (session && active > 0 && activeGrows(turn, workspace)
        && workspace.seeds()
               .past()
               .of(*session, workspace.growthPlane())
               .growing.test(std::size_t(active)))
        return active;
    return turn.segments && turn.segments->size() == 1 ? turn.segments->front() : 0;
}

bool everySegmentLocked(const core::Document& document, std::uint8_t plane)
{
    return document.lockedLabels(plane).any() && document.unlockedLabels(plane).none();
}

QString textOf(const std::vector<GrowthTurn>& turns, const Workspace& workspace)
{
    if (turns.empty() || !turns.front().segments || !workspace.session())
        return {};
    const core::Document& document = workspace.session()->document();
    if (turns.size() > 1) {
        QStringList names;
        for (const GrowthTurn& turn : turns)
            names += namesOf(turn, document);
        return Texts::tr("One after the other, each in its own interval: %1.")
            .arg(names.join(QStringLiteral(", ")));
    }
    const GrowthTurn& turn = turns.front();
    if (turn.segments->size() == 1)
        return Texts::tr("Only %1 grows: the others have intervals of their own.")
            .arg(namesOf(turn, document));
    return Texts::tr("%1 grow together, in an interval that holds those of each: %2 … %3 %4")
        .arg(namesOf(turn, document), numberText(turn.lower, 1), numberText(turn.upper, 1),
            workspace.volume()->unit)
        .trimmed();
}

} // namespace ui
