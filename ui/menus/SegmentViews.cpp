// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentViews.h"

#include "core/session/EditSession.h"
#include "core/session/questions/SegmentsAt.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/Actions.h"
#include "ui/base/MenuText.h"
#include "ui/measure/CentreOnSegment.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>
#include <QSettings>

#include <algorithm>
#include <array>
#include <vector>

namespace ui {

namespace {

using Drawing = Workspace::SegmentDrawing;

constexpr QLatin1String drawingKey("segments/drawing");
constexpr QLatin1String fillKey("segments/fillPercent");
constexpr QLatin1String voxelTrueKey("segments/voxelTrue");
constexpr int fillStepPercent = 5;

/// In the settings, by Drawing.
constexpr std::array<const char*, 3> drawingNames{"fillAndOutline", "fill", "outline"};

void restoreDrawing(Workspace& workspace)
{
    const QSettings settings;
    Workspace::ViewOptions options = workspace.viewOptions();
    const QString name = settings.value(drawingKey).toString();
    for (std::size_t each = 0; each < drawingNames.size(); ++each) {
        if (name == QLatin1String(drawingNames[each]))
            options.segmentDrawing = Drawing(each);
    }
    bool isNumber = false;
    const int percent = settings.value(fillKey).toInt(&isNumber);
    if (isNumber)
        options.segmentFillPercent = std::clamp(percent, Workspace::leastSegmentFill, 100);
    options.voxelTrueSegments = settings.value(voxelTrueKey).toString() == QLatin1String("true");
    workspace.setViewOptions(options);
}

void setVoxelTrue(Workspace& workspace, bool voxelTrue)
{
    Workspace::ViewOptions options = workspace.viewOptions();
    options.voxelTrueSegments = voxelTrue;
    workspace.setViewOptions(options);
    QSettings().setValue(voxelTrueKey, voxelTrue ? QLatin1String("true") : QLatin1String("false"));
}

void setDrawing(Workspace& workspace, Drawing drawing)
{
    Workspace::ViewOptions options = workspace.viewOptions();
    options.segmentDrawing = drawing;
    workspace.setViewOptions(options);
    QSettings().setValue(drawingKey, QLatin1String(drawingNames[std::size_t(drawing)]));
}

void changeFill(Workspace& workspace, int byPercent)
{
    Workspace::ViewOptions options = workspace.viewOptions();
    options.segmentFillPercent =
        std::clamp(options.segmentFillPercent + byPercent, Workspace::leastSegmentFill, 100);
    workspace.setViewOptions(options);
    QSettings().setValue(fillKey, options.segmentFillPercent);
    workspace.say(
        QObject::tr("Segments are filled to %1 % in slices").arg(options.segmentFillPercent));
}

const core::Segment* activeOne(const Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    return session ? session->document().segment(workspace.activeSegment()) : nullptr;
}

void activate(Workspace& workspace, const core::Segment& segment)
{
    const QString name = segment.name;
    workspace.setActiveSegment(segment.label);
    workspace.say(QObject::tr("'%1' is active").arg(name));
}

/// From the last one on to the first, and back.
void activateNeighbour(Workspace& workspace, int by)
{
    const std::vector<core::Segment>& segments = workspace.session()->document().segments;
    const int count = int(segments.size());
    const core::Segment* active = activeOne(workspace);
    const int place = active ? int(active - segments.data()) + by : by > 0 ? 0 : count - 1;
    activate(workspace, segments[std::size_t((place + count) % count)]);
}

QString aloneText(const Workspace& workspace)
{
    const core::Segment* active = activeOne(workspace);
    if (!active)
        return QObject::tr("Show only segment");
    return showAloneText(workspace, *active);
}

void addSteps(Actions& actions, Workspace& workspace)
{
    const auto any = [&workspace] {
        return workspace.session() && !workspace.session()->document().segments.empty();
    };
    actions.add({.id = QStringLiteral("segments.previous"),
        .text = QObject::tr("Previous segment"),
        .keys = {QKeySequence(QStringLiteral("Q"))},
        .run = [&workspace] { activateNeighbour(workspace, -1); },
        .possible = any});
    actions.add({.id = QStringLiteral("segments.next"),
        .text = QObject::tr("Next segment"),
        .keys = {QKeySequence(QStringLiteral("W"))},
        .run = [&workspace] { activateNeighbour(workspace, 1); },
        .possible = any});
    actions.add({.id = QStringLiteral("segments.centre"),
        .text = QObject::tr("Centre views on segment"),
        .keys = {QKeySequence(QStringLiteral("Shift+J"))},
        .tip = QObject::tr("The crosshair goes to the middle of the active segment, and every view "
                           "shows it in its middle"),
        .run = [&workspace] { centreOnSegment(workspace, workspace.activeSegment()); },
        .possible = [&workspace] { return activeOne(workspace) != nullptr; },
        .currentText =
            [&workspace] {
                const core::Segment* active = activeOne(workspace);
                return active ? QObject::tr("Centre views on '%1'").arg(menuText(active->name))
                              : QObject::tr("Centre views on segment");
            }});
    QAction& alone = actions.add({.id = QStringLiteral("segments.alone"),
        .text = QObject::tr("Show only segment"),
        .keys = {QKeySequence(QStringLiteral("Shift+W"))},
        .run = [&workspace] { workspace.viewSteps().showAlone(workspace.activeSegment()); },
        .possible =
            [&workspace] {
                return activeOne(workspace) && workspace.session()->document().segments.size() > 1;
            },
        .currentText = [&workspace] { return aloneText(workspace); }});
    // A key that is held would show them in turns.
    alone.setAutoRepeat(false);
}

void addDrawings(Actions& actions, Workspace& workspace)
{
    struct Choice {
        const char* id;
        QString text;
        Drawing drawing;
    };
    for (const Choice& choice : {Choice{"segments.fillAndOutline", QObject::tr("Fill and outline"),
                                     Drawing::FillAndOutline},
             Choice{"segments.fill", QObject::tr("Fill"), Drawing::Fill},
             Choice{"segments.outline", QObject::tr("Outline"), Drawing::Outline}})
        actions.add({.id = QLatin1String(choice.id),
            .text = choice.text,
            .run = [&workspace, drawing = choice.drawing] { setDrawing(workspace, drawing); },
            .checked =
                [&workspace, drawing = choice.drawing] {
                    return workspace.viewOptions().segmentDrawing == drawing;
                }});
    const auto filled = [&workspace] {
        return workspace.volume() && workspace.viewOptions().segmentDrawing != Drawing::Outline;
    };
    actions.add({.id = QStringLiteral("segments.fillLess"),
        .text = QObject::tr("Fill less opaque"),
        .keys = {QKeySequence(QStringLiteral(","))},
        .run = [&workspace] { changeFill(workspace, -fillStepPercent); },
        .possible = filled});
    actions.add({.id = QStringLiteral("segments.fillMore"),
        .text = QObject::tr("Fill more opaque"),
        .keys = {QKeySequence(QStringLiteral("."))},
        .run = [&workspace] { changeFill(workspace, fillStepPercent); },
        .possible = filled});
}

void addBodies(Actions& actions, Workspace& workspace)
{
    struct Choice {
        const char* id;
        QString text;
        QString tip;
        bool voxelTrue;
    };
    for (const Choice& choice :
        {Choice{"segments.smoothBodies", QObject::tr("Smooth"),
             QObject::tr("The surfaces of segments are smoothed to be looked at"), false},
            Choice{"segments.voxelTrueBodies", QObject::tr("Voxel by voxel"),
                QObject::tr("Segments are the cubes of their voxels, as an export has them"),
                true}})
        actions.add({.id = QLatin1String(choice.id),
            .text = choice.text,
            .tip = choice.tip,
            .run = [&workspace, wanted = choice.voxelTrue] { setVoxelTrue(workspace, wanted); },
            .checked =
                [&workspace, wanted = choice.voxelTrue] {
                    return workspace.viewOptions().voxelTrueSegments == wanted;
                }});
}

} // namespace

QString showAloneText(const Workspace& workspace, const core::Segment& segment)
{
    if (!isShownAlone(workspace.session()->document(), segment.label))
        return QObject::tr("Show only '%1'").arg(menuText(segment.name));
    return workspace.viewSteps().knowsOthers(segment.label) ? QObject::tr("Show the others again")
                                                            : QObject::tr("Show all segments");
}

void addSegmentViews(Actions& actions, Workspace& workspace)
{
    addSteps(actions, workspace);
    addDrawings(actions, workspace);
    addBodies(actions, workspace);
    restoreDrawing(workspace);
}

void activateSegmentAt(Workspace& workspace, const glm::dvec3& placeLps)
{
    core::EditSession* session = workspace.session();
    if (!session || !workspace.volume())
        return;
    const core::VolumeGeometry& geometry = workspace.volume()->geometry;
    const glm::ivec3 voxel(glm::floor(geometry.toIndex(placeLps) + 0.5));
    if (!geometry.contains(voxel))
        return workspace.say(QObject::tr("No segment lies there"));
    session->questions().probe({voxel}, [asked = QPointer(&workspace)](const auto& probes) {
        if (!asked || !asked->session())
            return;
        if (!probes)
            return asked->fail(probes.error());
        const core::Segment* segment = probes->empty()
            ? nullptr
            : core::segmentNext(
                asked->session()->document(), probes->front(), asked->activeSegment());
        if (segment)
            activate(*asked, *segment);
        else
            asked->say(QObject::tr("No segment lies there"));
    });
}

} // namespace ui
