// SPDX-License-Identifier: Apache-2.0
#include "ui/input/RestingTool.h"

#include "ui/input/Tool.h"

#include <QCoreApplication>

#include <variant>

namespace ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("ui::RestingTool", text);
}

} // namespace

QString whyToolRests(const Tool& tool, const ViewContext& view)
{
    if (view.isSlice())
        return tr("%1 works in the 3D view").arg(tool.longName());
    ViewContext withVolume = view;
    auto& scene = std::get<gpu::VolumeScene>(withVolume.scene);
    const bool isCutAway = scene.context == gpu::Context::CutAway;
    scene.context = gpu::Context::Opaque;
    if (!tool.worksIn(withVolume))
        return tr("%1 works in the slices").arg(tool.longName());
    return (isCutAway ? tr("%1 works on the whole volume: switch off cut away in the view")
                      : tr("%1 works on the volume: choose Volume or both in the view"))
        .arg(tool.longName());
}

} // namespace ui
