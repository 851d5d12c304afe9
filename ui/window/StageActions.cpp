// SPDX-License-Identifier: Apache-2.0
#include "ui/window/StageActions.h"

#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"

#include <algorithm>

namespace ui {

namespace {

void addStereo(MainWindow& window, const char* id, const char* text, Stereo::Mode mode)
{
    VolumeView& view = window.views().volume();
    window.actionTable().add({.id = QLatin1String(id),
        .text = QLatin1String(text),
        .run =
            [&view, mode] {
                Stereo stereo = view.stereo();
                stereo.mode = mode;
                view.setStereo(stereo);
            },
        .checked = [&view, mode] { return view.stereo().mode == mode; }});
}

/// What the 3D view shows of the volume beside the segments.
void addContext(MainWindow& window)
{
    Actions& actions = window.actionTable();
    Workspace& workspace = window.workspace();
    struct Choice {
        const char* id;
        QString text;
        const char* key;
        gpu::Context context;
    };
    for (const Choice& choice :
        {Choice{"view.contextOpaque", Actions::tr("Volume"), "Alt+5", gpu::Context::Opaque},
            Choice{"view.contextTranslucent", Actions::tr("Volume and segments"), "Alt+6",
                gpu::Context::Translucent},
            Choice{"view.contextCutAway", Actions::tr("Volume cut away before segments"), "Alt+7",
                gpu::Context::CutAway},
            Choice{
                "view.contextHidden", Actions::tr("Segments only"), "Alt+8", gpu::Context::Hidden}})
        actions.add({.id = QLatin1String(choice.id),
            .text = choice.text,
            .keys = {QKeySequence(QLatin1String(choice.key))},
            .run =
                [&workspace, context = choice.context] {
                    Workspace::VolumeDisplay display = workspace.volumeDisplay();
                    display.context = context;
                    workspace.setVolumeDisplay(display);
                },
            .checked =
                [&workspace, context = choice.context] {
                    return workspace.volumeDisplay().context == context;
                }});
}

} // namespace

QStringList addStageActions(MainWindow& window)
{
    constexpr double stepDegrees = 5.0;
    constexpr double eyesStep = 0.5;
    addContext(window);
    Actions& actions = window.actionTable();
    VolumeView& view = window.views().volume();
    struct Turn {
        const char* id;
        const char* text;
        const char* key;
        double rightwards;
        double downwards;
    };
    for (const Turn& turn : {Turn{"view.turnLeft", "Turn to the left", "Alt+Left", -1.0, 0.0},
             Turn{"view.turnRight", "Turn to the right", "Alt+Right", 1.0, 0.0},
             Turn{"view.turnUp", "Turn upwards", "Alt+Up", 0.0, -1.0},
             Turn{"view.turnDown", "Turn downwards", "Alt+Down", 0.0, 1.0}})
        actions.add({.id = QLatin1String(turn.id),
            .text = QLatin1String(turn.text),
            .keys = {QKeySequence(QLatin1String(turn.key))},
            .run = [&view, turn] {
                view.turn(turn.rightwards * stepDegrees, turn.downwards * stepDegrees);
            }});
    addStereo(window, "view.stereoOff", "One eye", Stereo::Mode::Off);
    addStereo(window, "view.anaglyph", "Anaglyph, red and cyan", Stereo::Mode::Anaglyph);
    addStereo(window, "view.sideBySide", "Side by side", Stereo::Mode::SideBySide);
    const auto eyes = [&](const char* id, const char* text, const char* key, double by) {
        actions.add({.id = QLatin1String(id),
            .text = QLatin1String(text),
            .keys = {QKeySequence(QLatin1String(key))},
            .run =
                [&view, by] {
                    Stereo stereo = view.stereo();
                    stereo.eyesDegrees = std::clamp(
                        stereo.eyesDegrees + by, Stereo::leastDegrees, Stereo::mostDegrees);
                    view.setStereo(stereo);
                },
            .possible = [&view] { return view.stereo().mode != Stereo::Mode::Off; }});
    };
    eyes("view.eyesApart", "Eyes further apart", "Alt++", eyesStep);
    eyes("view.eyesCloser", "Eyes closer together", "Alt+-", -eyesStep);
    actions.add({.id = QStringLiteral("view.eyesSwapped"),
        .text = Actions::tr("Left and right eye swapped"),
        .run =
            [&view] {
                Stereo stereo = view.stereo();
                stereo.swapped = !stereo.swapped;
                view.setStereo(stereo);
            },
        .possible = [&view] { return view.stereo().mode != Stereo::Mode::Off; },
        .checked = [&view] { return view.stereo().swapped; }});
    QObject::connect(&view, &VolumeView::stereoChanged, &actions, &Actions::refresh);
    return {QStringLiteral("view.turnLeft"), QStringLiteral("view.turnRight"),
        QStringLiteral("view.turnUp"), QStringLiteral("view.turnDown"), QString(),
        QStringLiteral("view.stereoOff"), QStringLiteral("view.anaglyph"),
        QStringLiteral("view.sideBySide"), QStringLiteral("view.eyesApart"),
        QStringLiteral("view.eyesCloser"), QStringLiteral("view.eyesSwapped")};
}

} // namespace ui
