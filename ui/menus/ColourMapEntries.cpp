// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/ColourMapEntries.h"

#include "ui/workspace/Workspace.h"

#include <QActionGroup>
#include <QMenu>

namespace ui {

const std::vector<ColourMapEntry>& colourMapEntries()
{
    static const std::vector<ColourMapEntry> entries{
        {"view.coloursGrey", QObject::tr("Grey"), gpu::ColourMap::Grey},
        {"view.coloursHotIron", QObject::tr("Hot iron"), gpu::ColourMap::HotIron},
        {"view.coloursHotMetalBlue", QObject::tr("Hot metal blue"), gpu::ColourMap::HotMetalBlue},
        {"view.coloursPet20Step", QObject::tr("PET, 20 steps"), gpu::ColourMap::Pet20Step},
        {"view.coloursEvenLightness", QObject::tr("Blue to yellow, evenly lighter"),
            gpu::ColourMap::EvenLightness},
    };
    return entries;
}

void showColours(Workspace& workspace, gpu::ColourMap map)
{
    Workspace::ViewOptions options = workspace.viewOptions();
    options.colours = map;
    workspace.setViewOptions(options);
}

void addColourMaps(QMenu& menu, Workspace& workspace)
{
    QMenu* colours = menu.addMenu(QObject::tr("Colours of slices"));
    colours->setObjectName(QStringLiteral("coloursOfSlices"));
    auto* onlyOne = new QActionGroup(colours);
    for (const ColourMapEntry& each : colourMapEntries()) {
        QAction* action = colours->addAction(
            each.text, &workspace, [&workspace, &each] { showColours(workspace, each.map); });
        action->setCheckable(true);
        action->setChecked(each.map == workspace.viewOptions().colours);
        onlyOne->addAction(action);
    }
}

} // namespace ui
