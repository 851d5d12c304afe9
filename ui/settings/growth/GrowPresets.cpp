// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/GrowPresets.h"

#include <QObject>

namespace ui {

const std::vector<GrowPreset>& growPresets()
{
    static const std::vector<GrowPreset> presets{
        {.name = QObject::tr("Organ, lesion or fluid"),
            .tip = QObject::tr("Smooth: a little; smooth noise; neighbours share a face"),
            .smooth = smoothALittle,
            .smoothing = true,
            .connectivity = 6},
        {.name = QObject::tr("The same in much noise"),
            .tip = QObject::tr("Smooth: more; smooth noise; neighbours share a face"),
            .smooth = smoothMore,
            .smoothing = true,
            .connectivity = 6},
        {.name = QObject::tr("Vessels, airways or thin walls"),
            .tip = QObject::tr("Smooth: off; noise as it is; neighbours share at least a corner"),
            .smooth = 0,
            .smoothing = false,
            .connectivity = 26},
    };
    return presets;
}

void takePreset(const GrowPreset& preset, GrowSettings& settings)
{
    settings.majority.on = preset.smooth > 0;
    if (preset.smooth > 0)
        settings.majority.value = preset.smooth;
    settings.smoothing = preset.smoothing;
    settings.passage.on = false;
    settings.connectivity = preset.connectivity;
}

bool areOf(const GrowSettings& settings, const GrowPreset& preset)
{
    GrowSettings taken = settings;
    takePreset(preset, taken);
    return taken == settings;
}

} // namespace ui
