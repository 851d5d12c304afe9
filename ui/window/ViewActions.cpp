// SPDX-License-Identifier: Apache-2.0
#include "ui/window/ViewActions.h"

#include "ui/base/NumberText.h"
#include "ui/input/HeldKey.h"
#include "ui/menus/ColourMapEntries.h"
#include "ui/menus/InterpolationEntries.h"
#include "ui/menus/SliceTurnEntries.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/BookmarkMenu.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/InitialDisplay.h"

#include <QActionGroup>

#include <algorithm>
#include <array>

namespace ui {

namespace {

/// The standard sides, with the letters they are known by.
struct Side {
    const char* id;
    const char* text;
    const char* key;
    glm::dvec3 direction;
};
const std::array<Side, 6> sides{
    Side{"view.fromFront", "From the front (A)", "Shift+A", {0.0, -1.0, 0.0}},
    Side{"view.fromBack", "From the back (P)", "Shift+P", {0.0, 1.0, 0.0}},
    Side{"view.fromLeft", "From the left (L)", "Shift+L", {1.0, 0.0, 0.0}},
    Side{"view.fromRight", "From the right (R)", "Shift+R", {-1.0, 0.0, 0.0}},
    Side{"view.fromAbove", "From above (S)", "Shift+S", {0.0, 0.0, 1.0}},
    Side{"view.fromBelow", "From below (I)", "Shift+I", {0.0, 0.0, -1.0}},
};

void addToggle(MainWindow& window, const char* id, const char* text, const char* key,
    bool Workspace::ViewOptions::*option)
{
    Workspace& workspace = window.workspace();
    window.actionTable().add({.id = QLatin1String(id),
        .text = QLatin1String(text),
        .keys =
            *key ? QList<QKeySequence>{QKeySequence(QLatin1String(key))} : QList<QKeySequence>(),
        .run =
            [&workspace, option] {
                Workspace::ViewOptions options = workspace.viewOptions();
                options.*option = !(options.*option);
                workspace.setViewOptions(options);
            },
        .checked = [&workspace, option] { return workspace.viewOptions().*option; }});
}

void addLayout(MainWindow& window, const char* id, const char* text, const char* key,
    const std::function<ImageView*()>& view)
{
    window.actionTable().add({.id = QLatin1String(id),
        .text = QLatin1String(text),
        .keys = {QKeySequence(QLatin1String(key))},
        .run = [&window, view] { window.views().maximise(view()); },
        .checked = [&window, view] { return window.views().maximised() == view(); }});
}

void addMode(
    MainWindow& window, const char* id, const char* text, const char* key, gpu::RenderMode mode)
{
    Workspace& workspace = window.workspace();
    window.actionTable().add({.id = QLatin1String(id),
        .text = QLatin1String(text),
        .keys = {QKeySequence(QLatin1String(key))},
        .run =
            [&workspace, mode] {
                Workspace::VolumeDisplay display = workspace.volumeDisplay();
                display.mode = mode;
                workspace.setVolumeDisplay(display);
            },
        .checked = [&workspace, mode] { return workspace.volumeDisplay().mode == mode; }});
}

void addSlab(MainWindow& window, const char* id, const char* text, gpu::SlabMode mode)
{
    Workspace& workspace = window.workspace();
    window.actionTable().add({.id = QLatin1String(id),
        .text = QLatin1String(text),
        .run =
            [&workspace, mode] {
                Workspace::ViewOptions options = workspace.viewOptions();
                options.slabMode = mode;
                workspace.setViewOptions(options);
            },
        .checked = [&workspace, mode] { return workspace.viewOptions().slabMode == mode; }});
}

void addColours(MainWindow& window)
{
    Workspace& workspace = window.workspace();
    auto* onlyOne = new QActionGroup(&window);
    for (const ColourMapEntry& each : colourMapEntries())
        onlyOne->addAction(&window.actionTable().add({.id = QLatin1String(each.id),
            .text = each.text,
            .run = [&workspace, &each] { showColours(workspace, each.map); },
            .checked = [&workspace,
                           &each] { return workspace.viewOptions().colours == each.map; }}));
}

void addInterpolationActions(MainWindow& window)
{
    Workspace& workspace = window.workspace();
    auto* onlyOne = new QActionGroup(&window);
    for (const InterpolationEntry& each : interpolationEntries())
        onlyOne->addAction(&window.actionTable().add({.id = QLatin1String(each.id),
            .text = each.text,
            .run = [&workspace, &each] { interpolate(workspace, each.interpolation); },
            .checked =
                [&workspace, &each] {
                    return workspace.viewOptions().interpolation == each.interpolation;
                }}));
}

void addTurns(MainWindow& window)
{
    for (const SliceTurnEntry& each : sliceTurnEntries()) {
        window.actionTable().add({.id = QLatin1String(each.id),
            .text = each.text,
            .run =
                [&window, &each] {
                    if (auto* slice = qobject_cast<SliceView*>(&window.views().current()))
                        slice->setTurn(each.after(slice->turn()));
                    else
                        window.workspace().say(Actions::tr(
                            "Only slices are flipped and turned so: point at one first."));
                },
            .possible = [&window] { return window.workspace().volume() != nullptr; }});
    }
}

void addPlanesReset(MainWindow& window)
{
    window.actionTable().add({.id = QStringLiteral("view.alongPatient"),
        .text = Actions::tr("Slices along the patient again"),
        .tip = Actions::tr("Turns the crosshair back whose handles were dragged"),
        .run = [&window] { window.views().planes().reset(); },
        .possible = [&window] { return window.workspace().volume() != nullptr; }});
}

void addPresetActions(MainWindow& window)
{
    Workspace& workspace = window.workspace();
    const auto preset = [&workspace](int number) -> std::optional<WindowPreset> {
        const core::Volume* volume = workspace.volume();
        if (!volume)
            return std::nullopt;
        const auto presets = windowPresets(*volume);
        if (number > int(presets.size()))
            return std::nullopt;
        return presets[std::size_t(number - 1)];
    };
    for (int number = 1; number <= 9; ++number) {
        window.actionTable().add({.id = QStringLiteral("window.preset%1").arg(number),
            .text = QString(),
            .keys = {QKeySequence(QString::number(number))},
            .run =
                [&workspace, preset, number] {
                    if (const auto chosen = preset(number))
                        workspace.setWindowLevel(chosen->window);
                },
            .possible = [preset, number] { return preset(number).has_value(); },
            .checked =
                [&workspace, preset, number] {
                    const auto chosen = preset(number);
                    return chosen && chosen->window == workspace.windowLevel();
                },
            .currentText =
                [&workspace, preset, number] {
                    const auto chosen = preset(number);
                    if (!chosen)
                        return QStringLiteral("—");
                    const core::Volume& volume = *workspace.volume();
                    const int decimals = decimalsForSpan(volume.maximum - volume.minimum);
                    return QStringLiteral("%1  (%2 / %3)")
                        .arg(chosen->name)
                        .arg(chosen->window.width, 0, 'f', decimals)
                        .arg(chosen->window.centre, 0, 'f', decimals);
                }});
    }
}

} // namespace

void addViewActions(MainWindow& window)
{
    Actions& actions = window.actionTable();
    addTurns(window);
    addPlanesReset(window);
    actions.add({.id = QStringLiteral("view.four"),
        .text = Actions::tr("Four views"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+1"))},
        .run = [&window] { window.views().arrange(ViewGrid::Layout::Four); },
        .checked =
            [&window] {
                return window.views().arrangement() == ViewGrid::Layout::Four
                    && !window.views().maximised();
            }});
    addLayout(window, "view.volume", "3D alone", "Ctrl+2",
        [&window] { return &window.views().volume(); });
    addLayout(window, "view.axial", "Axial alone", "Ctrl+3",
        [&window] { return &window.views().axial(); });
    addLayout(window, "view.sagittal", "Sagittal alone", "Ctrl+4",
        [&window] { return &window.views().sagittal(); });
    addLayout(window, "view.coronal", "Coronal alone", "Ctrl+5",
        [&window] { return &window.views().coronal(); });
    actions.add({.id = QStringLiteral("view.reset"),
        .text = Actions::tr("Reset view"),
        .keys = {QKeySequence(QStringLiteral("R"))},
        .icon = QStringLiteral("reset-view"),
        .run = [&window] { window.views().current().resetView(); }});
    actions.add({.id = QStringLiteral("view.resetAll"),
        .text = Actions::tr("Reset all views"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+R"))},
        .run = [&window] { window.views().resetViews(); }});
    actions.add({.id = QStringLiteral("view.bookmark"),
        .text = Actions::tr("Bookmark this view …"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+B"))},
        .run = [&window] { window.bookmarks().ask(); },
        .possible = [&window] { return window.workspace().session() != nullptr; }});
    actions.add({.id = QStringLiteral("window.box"),
        .text = Actions::tr("From a box on a slice"),
        .tip = Actions::tr("The next box that you drag over a slice sets the grey scale from "
                           "its values; Ctrl and the right button do so at any time"),
        .run = [&window] { window.views().awaitBox(!window.views().awaitsBox()); },
        .possible = [&window] { return window.workspace().volume() != nullptr; },
        .checked = [&window] { return window.views().awaitsBox(); }});
    addToggle(
        window, "view.inverted", "Inverted grey scale", "I", &Workspace::ViewOptions::inverted);
    addColours(window);
    addInterpolationActions(window);
    addToggle(window, "view.crosshair", "Crosshair", "F7", &Workspace::ViewOptions::showCrosshair);
    addToggle(window, "view.referenceLines", "Reference lines in slices", "",
        &Workspace::ViewOptions::referenceLines);
    addToggle(window, "view.patient", "Patient in the corners", "F8",
        &Workspace::ViewOptions::showPatient);
    addToggle(window, "view.segments", "Segments", "H", &Workspace::ViewOptions::showSegments);
    new HeldKey(actions[QStringLiteral("view.segments")]);
    actions.add({.id = QStringLiteral("segments.underPointer"),
        .text = Actions::tr("Segment under the pointer"),
        .keys = {QKeySequence(QStringLiteral("Shift+Q"))},
        .run =
            [&window] {
                const auto views = window.views().views();
                const bool pointed = std::any_of(views.begin(), views.end(),
                    [](ImageView* view) { return view->activateSegmentUnderPointer(); });
                if (!pointed)
                    window.workspace().say(Actions::tr("Point at a segment in a view first"));
            },
        .possible = [&window] { return window.workspace().session() != nullptr; }});
    addToggle(window, "view.carved", "Outline of carving in slices", "Shift+H",
        &Workspace::ViewOptions::showCarved);
    addToggle(
        window, "view.barriers", "Barriers of growth", "", &Workspace::ViewOptions::showBarriers);
    addToggle(window, "view.hole", "Carving as a hole in slices", "",
        &Workspace::ViewOptions::carvedAsHole);
    addToggle(window, "view.linkedPlaces", "Zoom and pan all slices together", "",
        &Workspace::ViewOptions::linkedPlaces);
    addSlab(window, "view.slabOff", "Slices: no slab", gpu::SlabMode::Off);
    addSlab(window, "view.slabMip", "Slices: slab, greatest value (MIP)", gpu::SlabMode::Maximum);
    addSlab(window, "view.slabMinip", "Slices: slab, least value (MinIP)", gpu::SlabMode::Minimum);
    addSlab(window, "view.slabMean", "Slices: slab, mean", gpu::SlabMode::Mean);
    actions.add({.id = QStringLiteral("view.panels"),
        .text = Actions::tr("Show panels"),
        .keys = {QKeySequence(QStringLiteral("F9"))},
        .run = [&window] { window.showPanels(!window.panelsShown()); },
        .checked = [&window] { return window.panelsShown(); }});
    actions.add({.id = QStringLiteral("view.resetPanels"),
        .text = Actions::tr("All panels back into the column"),
        .run = [&window] { window.resetPanels(); }});
    actions.add({.id = QStringLiteral("view.fullScreen"),
        .text = Actions::tr("Full screen"),
        .keys = {QKeySequence(QStringLiteral("F11"))},
        .run = [&window] { window.setWindowState(window.windowState() ^ Qt::WindowFullScreen); },
        .checked = [&window] { return window.isFullScreen(); }});
    addMode(window, "view.surface", "Isosurface", "Alt+1", gpu::RenderMode::Surface);
    addMode(window, "view.dvr", "Volume rendering", "Alt+2", gpu::RenderMode::Dvr);
    addMode(window, "view.mip", "Maximum intensity", "Alt+3", gpu::RenderMode::Mip);
    addMode(window, "view.xray", "X-ray", "Alt+4", gpu::RenderMode::Xray);
    for (const Side& side : sides) {
        actions.add({.id = QLatin1String(side.id),
            .text = QLatin1String(side.text),
            .keys = {QKeySequence(QLatin1String(side.key))},
            .run = [&window, &side] { window.views().volume().lookFrom(side.direction); }});
    }
    addPresetActions(window);
}

} // namespace ui
