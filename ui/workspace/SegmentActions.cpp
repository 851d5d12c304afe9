// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/SegmentActions.h"

#include "core/document/SegmentColours.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/NumberText.h"
#include "ui/base/RowTitleText.h"
#include "ui/base/StudyTexts.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>
#include <QTimer>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

namespace ui {

std::uint32_t nextSegmentColour(const core::Document& document)
{
    return core::usualSegmentColour(document.segments.size());
}

QString nextSegmentName(const core::Document& document)
{
    for (qsizetype number = qsizetype(document.segments.size()) + 1;; ++number) {
        const QString name = QObject::tr("Segment %1").arg(number);
        const bool taken = std::any_of(document.segments.begin(), document.segments.end(),
            [&name](const core::Segment& segment) { return segment.name == name; });
        if (!taken)
            return name;
    }
}

core::Result<int> addSegment(Workspace& workspace, std::uint8_t plane)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return core::failure(core::ErrorCode::Internal, core::Clause::saying("no study is open"));
    // While the engine is busy the new segment waits in line; its label is known all the same.
    const core::Document before = session->foreseenDocument();
    core::AddSegment edit;
    edit.name = nextSegmentName(before);
    edit.rgb = nextSegmentColour(before);
    edit.plane = core::namedPlane(plane);
    if (const auto added = session->apply(edit); !added)
        return tl::unexpected(added.error());
    const int label = session->foreseenDocument().segments.back().label;
    workspace.setActiveSegment(label);
    return label;
}

int activateSegment(Workspace& workspace)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return 0;
    const core::Document document = session->foreseenDocument();
    if (document.segments.empty())
        return 0;
    if (!document.segment(workspace.activeSegment()))
        workspace.setActiveSegment(document.segments.front().label);
    return workspace.activeSegment();
}

core::Result<int> ensureActiveSegment(Workspace& workspace)
{
    const int label = activateSegment(workspace);
    return label == 0 ? addSegment(workspace) : core::Result<int>(label);
}

void removeSegment(Workspace& workspace, int label)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    session->closeOpen();
    const core::Document before = session->foreseenDocument();
    const core::Segment* segment = before.segment(label);
    // What still waits for the engine may change the count.
    const bool counted = session->idle();
    if (const auto removed = session->apply(core::RemoveSegment{.segment = label}); !removed)
        return workspace.fail(removed.error());
    if (!segment) // an undo that waits before it may bring it
        return;
    if (workspace.activeSegment() == label) {
        const auto place = std::size_t(segment - before.segments.data());
        const bool isLast = place + 1 == before.segments.size();
        const std::size_t next = isLast ? place - 1 : place + 1;
        workspace.setActiveSegment(before.segments.size() > 1 ? before.segments[next].label : 0);
    }
    workspace.say(counted ? QObject::tr("Deleted '%1', %2 voxels; Ctrl+Z brings it back")
                                .arg(segment->name, countText(segment->voxels))
                          : QObject::tr("Deleted '%1'; Ctrl+Z brings it back").arg(segment->name));
}

double smallIslandMm3(const Workspace& workspace, const core::Segment& segment)
{
    const glm::dvec3 spacing = workspace.volume()->geometry.spacingMm();
    return std::min(100.0, 0.01 * double(segment.voxels) * spacing.x * spacing.y * spacing.z);
}

namespace {

/// The name of a segment; its number if there is none.
QString nameOfSegment(const Workspace& workspace, int label)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return QString::number(label);
    const core::Document document = session->foreseenDocument();
    const core::Segment* segment = document.segment(label);
    return segment ? segment->name : QString::number(label);
}

/// Words for a row that an edit has made.
using RowWords = std::function<QString(const Workspace&, const core::HistoryRow&)>;

QString plainWords(const Workspace&, const core::HistoryRow& row)
{
    return nameOf(row);
}

/// Both volumes, too.
RowWords wordsOfSplit(int label)
{
    return [label](const Workspace& workspace, const core::HistoryRow& row) {
        const core::Document& document = workspace.session()->document();
        const core::Segment* segment = document.segment(label);
        if (!segment)
            return nameOf(row);
        const core::Segment& made = document.segments.back();
        return QObject::tr("%1. %2").arg(nameOf(row),
            partsText(workspace, segment->name, segment->voxels, made.name, made.voxels));
    };
}

/// Has an edit carried out that may find nothing to do, and tells the user what it did.
/// @param start has it carried out
/// @param nothing what the user is told if there was nothing to do
void carryOutAndReport(Workspace& workspace, std::size_t kind, const QString& nothing,
    const std::function<core::Result<void>(core::EditSession&)>& start,
    const RowWords& words = plainWords)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    const std::size_t rows = session->history().rows().size();
    auto* failures = new QObject(&workspace);
    const auto failed = std::make_shared<bool>(false);
    QObject::connect(
        &workspace, &Workspace::failed, failures, [failed](const core::Error&) { *failed = true; });
    if (const auto started = start(*session); !started) {
        delete failures;
        return workspace.fail(started.error());
    }
    // Only when it has been looked at is it known whether there was anything.
    session->questions().afterAll([guard = QPointer(&workspace), watch = QPointer(failures),
                                      session, rows, nothing, kind, failed, words] {
        if (!guard || guard->session() != session || *failed) {
            delete watch;
            return;
        }
        // A growth that stood open has left a row of its own.
        const std::vector<core::HistoryRow>& now = session->history().rows();
        for (std::size_t row = rows; row < now.size(); ++row) {
            if (now[row].edit.kind() == kind) {
                delete watch;
                return guard->say(
                    QObject::tr("%1; Ctrl+Z takes it back").arg(words(*guard, now[row])));
            }
        }
        // A refusal may be told only when the session has taken in all answers.
        QTimer::singleShot(0, watch.data(), [guard, watch, session, nothing, failed] {
            watch->deleteLater();
            if (guard->session() == session && !*failed)
                guard->say(nothing);
        });
    });
}

/// What is told if nothing came of an edit; where editing is limited that may be why.
QString nothingText(const Workspace& workspace, const QString& nothing)
{
    const QString editable = workspace.editableText();
    return editable.isEmpty() ? nothing : QObject::tr("%1 (%2)").arg(nothing, editable);
}

/// How an edit is carried out as a whole.
struct Carried {
    bool isOpen = false; ///< it stands open already, as a preview
    RowWords words = plainWords; ///< what is told of its row
};

/// The same for an edit as a whole, which keeps to the editable range.
void carryOut(
    Workspace& workspace, core::Edit edit, const QString& nothing, const Carried& how = {})
{
    if (core::EditSession* session = workspace.session(); session && !how.isOpen)
        session->closeOpen();
    if (std::optional<core::EditableRange>* const range = core::editableRangeOf(edit))
        *range = workspace.editableRange();
    carryOutAndReport(
        workspace, edit.kind(), nothingText(workspace, nothing),
        [&edit, &how](core::EditSession& session) {
            if (!how.isOpen)
                return session.apply(edit);
            session.end(core::Ending::Commit);
            return core::Result<void>();
        },
        how.words);
}

/// What is told if there is nothing to clean.
QString nothingToClean(const Workspace& workspace, const core::CleanSegment& edit)
{
    const QString name = nameOfSegment(workspace, edit.segment);
    switch (edit.rule) {
    case core::IslandRule::FillHoles:
        return QObject::tr("'%1' has no hole that is closed on all sides").arg(name);
    case core::IslandRule::RemoveSmall:
        return QObject::tr("'%1' has no island below %2 mm³")
            .arg(name, numberText(edit.mm3.value_or(0.0), 1));
    case core::IslandRule::KeepLargest:
    case core::IslandRule::KeepClicked:
        return QObject::tr("'%1' is one island already").arg(name);
    case core::IslandRule::RemoveClicked:
    case core::IslandRule::GiveClicked:
        break;
    }
    return QObject::tr("'%1' has no island there").arg(name);
}

} // namespace

void cleanSegment(Workspace& workspace, const core::CleanSegment& edit, bool isOpen)
{
    carryOut(workspace, edit, nothingToClean(workspace, edit), {.isOpen = isOpen});
}

void fillHoles(Workspace& workspace, int label)
{
    cleanSegment(workspace, {.segment = label, .rule = core::IslandRule::FillHoles});
}

void keepLargestIsland(Workspace& workspace, int label)
{
    cleanSegment(workspace, {.segment = label, .rule = core::IslandRule::KeepLargest});
}

void removeSmallIslands(Workspace& workspace, int label)
{
    const core::EditSession* session = workspace.session();
    if (const core::Segment* segment = session ? session->document().segment(label) : nullptr)
        cleanSegment(workspace,
            {.segment = label,
                .rule = core::IslandRule::RemoveSmall,
                .mm3 = smallIslandMm3(workspace, *segment)});
}

void mirrorSegment(Workspace& workspace, const core::MirrorSegment& edit, bool isOpen)
{
    const QString name = nameOfSegment(workspace, edit.segment);
    carryOut(workspace, edit,
        edit.keep ? QObject::tr("'%1' has its mirror image already").arg(name)
                  : QObject::tr("'%1' is its own mirror image").arg(name),
        {.isOpen = isOpen});
}

void takeInverse(Workspace& workspace, const core::InvertSegment& edit, bool isOpen)
{
    const QString name = nameOfSegment(workspace, edit.segment);
    const auto words = [name](const Workspace&, const core::HistoryRow&) {
        return QObject::tr("Inverted '%1'").arg(name);
    };
    carryOut(workspace, edit, QObject::tr("'%1' stays as it is").arg(name),
        {.isOpen = isOpen, .words = words});
}

void invertSegment(Workspace& workspace, int label)
{
    takeInverse(workspace, {.segment = label});
}

std::optional<core::SplitSegment> splitOfPlane(const Workspace& workspace, int label)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return std::nullopt;
    const core::Document expected = session->foreseenDocument();
    const core::Segment* segment = expected.segment(label);
    if (!segment)
        return std::nullopt;
    const CuttingPlane::Pose& pose = workspace.plane().pose();
    return core::SplitSegment{.segment = label,
        .placeLps = pose.centreLps,
        .normalLps = pose.normalLps(),
        .into = core::usualParts(expected, *segment, 1).front()};
}

/// What lies behind the cutting plane, as its viewer sees it, becomes a new segment.
void splitByPlane(Workspace& workspace, int label)
{
    if (const std::optional<core::SplitSegment> edit = splitOfPlane(workspace, label))
        splitSegment(workspace, *edit);
}

void splitSegment(Workspace& workspace, const core::SplitSegment& edit, bool isOpen)
{
    carryOut(workspace, edit,
        QObject::tr("all of '%1' lies on one side of the cutting plane")
            .arg(nameOfSegment(workspace, edit.segment)),
        {.isOpen = isOpen, .words = wordsOfSplit(edit.segment)});
}

void splitByCurve(Workspace& workspace, const core::SplitByCurve& edit)
{
    if (core::EditSession* session = workspace.session())
        session->closeOpen();
    const QString name = nameOfSegment(workspace, edit.segment);
    const QString nothing = edit.open
        ? QObject::tr("all of '%1' lies on one side of the line").arg(name)
        : QObject::tr("the curve does not part '%1'").arg(name);
    carryOutAndReport(
        workspace, core::Edit(edit).kind(), nothingText(workspace, nothing),
        [&edit](core::EditSession& session) { return session.apply(edit); },
        wordsOfSplit(edit.segment));
}

QString partsText(const Workspace& workspace, const QString& name, std::int64_t voxels,
    const QString& otherName, std::int64_t otherVoxels)
{
    const core::Volume& volume = *workspace.volume();
    return QObject::tr("%1: %2 · %3: %4")
        .arg(name, millilitreText(volume, voxels), otherName, millilitreText(volume, otherVoxels));
}

void reshapeSegment(Workspace& workspace, const core::ReshapeSegment& edit, bool isOpen)
{
    carryOut(workspace, edit,
        QObject::tr("'%1' stays as it is").arg(nameOfSegment(workspace, edit.segment)),
        {.isOpen = isOpen});
}

void fillBetweenSlices(Workspace& workspace, const core::FillBetweenSlices& edit, bool isOpen)
{
    carryOut(workspace, edit,
        QObject::tr("There is nothing to fill between the slices of '%1'")
            .arg(nameOfSegment(workspace, edit.segment)),
        {.isOpen = isOpen});
}

void splitIslands(Workspace& workspace, const core::SplitIslands& edit, bool isOpen)
{
    carryOut(workspace, edit,
        QObject::tr("'%1' has no other island that is large enough")
            .arg(nameOfSegment(workspace, edit.segment)),
        {.isOpen = isOpen});
}

void floodFill(Workspace& workspace, const core::FloodFill& edit)
{
    carryOut(workspace, edit,
        QObject::tr("Nothing there can be given to '%1'")
            .arg(nameOfSegment(workspace, edit.segment)));
}

void evolveContour(Workspace& workspace, const core::EvolveContour& edit)
{
    carryOut(workspace, edit,
        QObject::tr("'%1' stays as it is").arg(nameOfSegment(workspace, edit.segment)));
}

void takeThreshold(Workspace& workspace, const core::ThresholdSegment& edit, bool isOpen)
{
    carryOut(workspace, edit,
        QObject::tr("'%1' stays as it is").arg(nameOfSegment(workspace, edit.segment)),
        {.isOpen = isOpen});
}

void removeIsland(Workspace& workspace, int label, const glm::dvec3& placeLps)
{
    cleanSegment(workspace,
        {.segment = label, .rule = core::IslandRule::RemoveClicked, .islandLps = placeLps});
}

void keepOnlyIsland(Workspace& workspace, int label, const glm::dvec3& placeLps)
{
    cleanSegment(workspace,
        {.segment = label, .rule = core::IslandRule::KeepClicked, .islandLps = placeLps});
}

void giveIsland(Workspace& workspace, int label, int to, const glm::dvec3& placeLps)
{
    cleanSegment(workspace,
        {.segment = label, .rule = core::IslandRule::GiveClicked, .islandLps = placeLps, .to = to});
}

namespace {

/// "Liver copy", "Liver copy 2" …: the first such name that is free. A very long name is cut.
QString nextCopyName(const core::Document& document, const core::Segment& segment)
{
    constexpr qsizetype most = 200; // a name has at most 256
    QString stem = segment.name.left(most);
    if (!stem.isEmpty() && stem.back().isHighSurrogate())
        stem.chop(1);
    for (int number = 1;; ++number) {
        const QString name = number == 1
            ? QObject::tr("%1 copy").arg(stem)
            : QObject::tr("%1 copy %2").arg(stem, QString::number(number));
        const bool isTaken = std::any_of(document.segments.begin(), document.segments.end(),
            [&name](const core::Segment& other) { return other.name == name; });
        if (!isTaken)
            return name;
    }
}

} // namespace

void duplicateSegment(Workspace& workspace, int label)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return;
    const core::Document expected = session->foreseenDocument();
    const core::Segment* segment = expected.segment(label);
    if (!segment)
        return;
    carryOut(workspace,
        core::CopySegment{.segment = label,
            .name = nextCopyName(expected, *segment),
            .rgb = nextSegmentColour(expected)},
        segment->voxels == 0 ? QObject::tr("'%1' has no voxels").arg(segment->name)
                             : QObject::tr("no voxel of '%1' was copied").arg(segment->name));
}

namespace {

/// What the user is told if combining two segments changed no voxel.
QString nothingToCombine(const Workspace& workspace, const core::CombineSegments& edit)
{
    const QString name = nameOfSegment(workspace, edit.segment);
    const QString other = nameOfSegment(workspace, edit.with);
    switch (edit.how) {
    case core::CombineSegments::How::Merge:
        if (const core::Segment* from = workspace.session()->document().segment(edit.with);
            from && from->voxels > 0)
            return QObject::tr("'%1' can give no voxel").arg(other);
        break;
    case core::CombineSegments::How::Swap:
        return QObject::tr("neither '%1' nor '%2' has voxels").arg(name, other);
    case core::CombineSegments::How::Union:
        return QObject::tr("no voxel of '%1' is free beside '%2'").arg(other, name);
    case core::CombineSegments::How::Subtract:
        return QObject::tr("'%1' and '%2' have no voxel in common").arg(name, other);
    case core::CombineSegments::How::Intersect:
        return QObject::tr("'%1' lies within '%2' as a whole").arg(name, other);
    }
    return QObject::tr("'%1' has no voxels").arg(other);
}

} // namespace

void combineSegments(Workspace& workspace, const core::CombineSegments& edit, bool isOpen)
{
    carryOut(workspace, edit, nothingToCombine(workspace, edit), {.isOpen = isOpen});
}

} // namespace ui
