// SPDX-License-Identifier: Apache-2.0
#include "ui/window/PlaneActions.h"

#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/CuttingPlane.h"

namespace ui {

namespace {

void addToggle(Actions& actions, CuttingPlane& plane, const Actions::Entry& entry,
    bool CuttingPlane::Look::*option)
{
    Actions::Entry made = entry;
    made.run = [&plane, option] {
        CuttingPlane::Look look = plane.look();
        look.*option = !(look.*option);
        plane.setLook(look);
    };
    made.checked = [&plane, option] { return plane.look().*option; };
    actions.add(std::move(made));
}

} // namespace

QStringList addPlaneActions(MainWindow& window)
{
    Actions& actions = window.actionTable();
    Workspace& workspace = window.workspace();
    CuttingPlane& plane = workspace.plane();
    const auto hasVolume = [&workspace] { return workspace.volume() != nullptr; };
    addToggle(actions, plane,
        {.id = QStringLiteral("plane.shown"),
            .text = Actions::tr("Cutting plane"),
            .tip = Actions::tr("In the 3D view, and as a line in slices"),
            .run = {},
            .possible = hasVolume},
        &CuttingPlane::Look::shown);
    addToggle(actions, plane,
        {.id = QStringLiteral("plane.clips"),
            .text = Actions::tr("Clip above the plane"),
            .keys = {QKeySequence(QStringLiteral("Ctrl+P"))},
            .run = {},
            .possible = [&plane, hasVolume] { return hasVolume() && plane.look().shown; }},
        &CuttingPlane::Look::clipsAbove);
    const auto add = [&](const char* id, const char* text, const std::function<void()>& run) {
        actions.add({.id = QLatin1String(id),
            .text = QLatin1String(text),
            .run = run,
            .possible = hasVolume});
    };
    add("plane.axial", "Axial through the crosshair",
        [&plane] { plane.align(SliceOrientation::Axial); });
    add("plane.sagittal", "Sagittal through the crosshair",
        [&plane] { plane.align(SliceOrientation::Sagittal); });
    add("plane.coronal", "Coronal through the crosshair",
        [&plane] { plane.align(SliceOrientation::Coronal); });
    add("plane.across", "Across what runs at the crosshair",
        [&plane, &workspace] { plane.askAcross(workspace.crosshairLps()); });
    add("plane.facing", "Through the crosshair, facing the viewer", [&plane, &window] {
        plane.setPose(CuttingPlane::poseFacing(
            window.workspace().crosshairLps(), -window.views().volume().camera().towardsViewer));
        plane.show();
    });
    add("plane.flip", "Seen from its other side", [&plane] { plane.flip(); });
    add("plane.look", "Look straight at it",
        [&plane, &window] { window.views().volume().lookFrom(-plane.pose().normalLps()); });

    ViewGrid& views = window.views();
    actions.add({.id = QStringLiteral("view.penAndStage"),
        .text = Actions::tr("Pen and stage"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+6"))},
        .tip = Actions::tr("The cutting plane beside the 3D view"),
        .run = [&views] { views.arrange(ViewGrid::Layout::PenAndStage); },
        .possible = hasVolume,
        .checked =
            [&views] {
                return views.arrangement() == ViewGrid::Layout::PenAndStage && !views.maximised();
            }});
    actions.add({.id = QStringLiteral("view.plane"),
        .text = Actions::tr("Cutting plane alone"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+7"))},
        .run =
            [&views, &plane] {
                plane.show();
                views.maximise(&views.plane());
            },
        .possible = [&views, hasVolume] { return hasVolume() && !views.isPenApart(); },
        .checked = [&views] { return views.maximised() == &views.plane(); }});
    actions.add({.id = QStringLiteral("view.penApart"),
        .text = Actions::tr("Cutting plane in a window of its own"),
        .tip = Actions::tr("For another screen, such as a pen display"),
        .run = [&views] { views.setPenApart(!views.isPenApart()); },
        .possible = hasVolume,
        .checked = [&views] { return views.isPenApart(); }});
    QObject::connect(&plane, &CuttingPlane::changed, &actions, &Actions::refresh);
    return {QStringLiteral("plane.shown"), QStringLiteral("plane.clips"), QString(),
        QStringLiteral("plane.axial"), QStringLiteral("plane.sagittal"),
        QStringLiteral("plane.coronal"), QStringLiteral("plane.facing"),
        QStringLiteral("plane.across"), QStringLiteral("plane.flip"), QStringLiteral("plane.look")};
}

} // namespace ui
