// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentEntries.h"

#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/session/EditSession.h"
#include "ui/base/MenuText.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

namespace ui {

namespace {

void askThreshold(Workspace& workspace, int label)
{
    const core::EditSession* session = workspace.session();
    if (session && !session->foreseenDocument().segment(label)) {
        const core::Result<int> made = ensureActiveSegment(workspace);
        if (!made)
            return workspace.fail(made.error());
        label = *made;
    }
    workspace.askForThreshold(label);
}

void askMargin(Workspace& workspace, int label)
{
    workspace.askToReshape(label, core::ShapeOperation::Grow);
}

void askShell(Workspace& workspace, int label)
{
    workspace.askToReshape(label, core::ShapeOperation::Hollow);
}

void askSmoothing(Workspace& workspace, int label)
{
    workspace.askToReshape(label, core::ShapeOperation::Median);
}

void askBetweenSlices(Workspace& workspace, int label)
{
    workspace.askToFillBetween(label);
}

void askToSplit(Workspace& workspace, int label)
{
    workspace.askToSplitIslands(label);
}

void askToMirror(Workspace& workspace, int label)
{
    workspace.askToMirror(label);
}

template <core::MirroredSides sides> void mirrorAtMiddle(Workspace& workspace, int label)
{
    mirrorSegment(workspace, {.segment = label, .sides = sides});
}

template <core::MirroredSides sides> void mirrorAtCrosshair(Workspace& workspace, int label)
{
    mirrorSegment(
        workspace, {.segment = label, .sides = sides, .placeLps = workspace.crosshairLps()});
}

QString whyNoPlane(const Workspace& workspace)
{
    return workspace.plane().look().shown ? QString() : QObject::tr("no cutting plane is shown");
}

} // namespace

QString namedText(const SegmentAction& action, const core::Segment* segment)
{
    if (!segment)
        return action.text;
    return action.named.isEmpty()
        ? QStringLiteral("%1 '%2'").arg(action.text, menuText(segment->name))
        : action.named.arg(menuText(segment->name));
}

const std::vector<SegmentAction>& segmentActions()
{
    static const QString cleanUp = QObject::tr("Clean up"); // as the panel with the same
    static const std::vector<SegmentAction> all{
        {.id = "segments.threshold",
            .text = QObject::tr("Threshold …"),
            .named = QObject::tr("Threshold for '%1' …"),
            .run = &askThreshold,
            .makesFirst = true},
        {.id = "segments.fillHoles",
            .text = QObject::tr("Fill holes"),
            .named = QObject::tr("Fill holes of '%1'"),
            .run = &fillHoles,
            .submenu = cleanUp},
        {.id = "segments.keepLargest",
            .text = QObject::tr("Keep largest island"),
            .named = QObject::tr("Keep largest island of '%1'"),
            .run = &keepLargestIsland,
            .submenu = cleanUp},
        {.id = "segments.removeSmall",
            .text = QObject::tr("Remove small islands"),
            .named = QObject::tr("Remove small islands of '%1'"),
            .run = &removeSmallIslands,
            .submenu = cleanUp},
        {.id = "segments.splitIslands",
            .text = QObject::tr("Split islands into segments …"),
            .named = QObject::tr("Split islands of '%1' into segments …"),
            .run = &askToSplit,
            .submenu = cleanUp},
        {.id = "segments.splitByPlane",
            .text = QObject::tr("Split by the cutting plane"),
            .named = QObject::tr("Split '%1' by the cutting plane"),
            .run = &splitByPlane,
            .submenu = cleanUp,
            .whyNot = &whyNoPlane},
        {.id = "segments.margin",
            .text = QObject::tr("Grow or shrink by a margin …"),
            .named = QObject::tr("Grow or shrink '%1' by a margin …"),
            .run = &askMargin,
            .submenu = cleanUp},
        {.id = "segments.hollow",
            .text = QObject::tr("Hollow …"),
            .named = QObject::tr("Hollow '%1' …"),
            .run = &askShell,
            .submenu = cleanUp},
        {.id = "segments.smooth",
            .text = QObject::tr("Smooth …"),
            .named = QObject::tr("Smooth '%1' …"),
            .run = &askSmoothing,
            .submenu = cleanUp},
        {.id = "segments.fillBetween",
            .text = QObject::tr("Fill between slices …"),
            .named = QObject::tr("Fill between slices of '%1' …"),
            .run = &askBetweenSlices,
            .submenu = cleanUp},
        {.id = "segments.mirror",
            .text = QObject::tr("Mirror left and right"),
            .named = QObject::tr("Mirror '%1' left and right"),
            .run = &mirrorAtMiddle<core::MirroredSides::RightLeft>,
            .submenu = QObject::tr("Mirror")},
        {.id = "segments.mirrorFrontBack",
            .text = QObject::tr("Mirror front and back"),
            .named = QObject::tr("Mirror '%1' front and back"),
            .run = &mirrorAtMiddle<core::MirroredSides::AnteriorPosterior>,
            .submenu = QObject::tr("Mirror")},
        {.id = "segments.mirrorHeadFeet",
            .text = QObject::tr("Mirror head and feet"),
            .named = QObject::tr("Mirror '%1' head and feet"),
            .run = &mirrorAtMiddle<core::MirroredSides::InferiorSuperior>,
            .submenu = QObject::tr("Mirror")},
        {.id = "segments.mirrorAtCrosshair",
            .text = QObject::tr("Mirror left and right at the crosshair"),
            .named = QObject::tr("Mirror '%1' left and right at the crosshair"),
            .run = &mirrorAtCrosshair<core::MirroredSides::RightLeft>,
            .submenu = QObject::tr("Mirror")},
        {.id = "segments.mirrorFrontBackAtCrosshair",
            .text = QObject::tr("Mirror front and back at the crosshair"),
            .named = QObject::tr("Mirror '%1' front and back at the crosshair"),
            .run = &mirrorAtCrosshair<core::MirroredSides::AnteriorPosterior>,
            .submenu = QObject::tr("Mirror")},
        {.id = "segments.mirrorHeadFeetAtCrosshair",
            .text = QObject::tr("Mirror head and feet at the crosshair"),
            .named = QObject::tr("Mirror '%1' head and feet at the crosshair"),
            .run = &mirrorAtCrosshair<core::MirroredSides::InferiorSuperior>,
            .submenu = QObject::tr("Mirror")},
        {.id = "segments.mirrorBy",
            .text = QObject::tr("Mirror …"),
            .named = QObject::tr("Mirror '%1' …"),
            .run = &askToMirror,
            .submenu = QObject::tr("Mirror")},
        {.id = "segments.duplicate",
            .text = QObject::tr("Duplicate segment"),
            .run = &duplicateSegment,
            .onlyReads = true},
        {.id = "segments.invert", .text = QObject::tr("Invert segment"), .run = &invertSegment},
        {.id = "segments.remove",
            .text = QObject::tr("Delete segment"),
            .keys = QKeySequence::Delete,
            .run = &removeSegment},
    };
    return all;
}

} // namespace ui
