// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/SliceTurn.h"
#include "ui/views/MprPlanes.h"
#include "ui/views/SliceView.h"

#include <QJsonObject>
#include <QJsonValue>
#include <QString>

namespace ui {
class VolumeView;
} // namespace ui

/// Where views look and how slices are drawn, as a session keeps it (DisplayState). Reading leaves
/// the target alone where there is nothing sensible.
namespace ui::displayJson {

[[nodiscard]] QString nameOf(gpu::SlabMode mode);
/// Off if no mode is called so.
[[nodiscard]] gpu::SlabMode slabNamed(const QString& name);
[[nodiscard]] QString nameOf(gpu::ColourMap map);
/// Grey if no map is called so.
[[nodiscard]] gpu::ColourMap coloursNamed(const QString& name);

[[nodiscard]] QJsonObject toJson(const SliceView::Place& place);
void apply(const QJsonValue& json, SliceView& view);
[[nodiscard]] QJsonObject toJson(const SliceTurn& turn);
void read(const QJsonValue& json, SliceTurn& turn);
[[nodiscard]] QJsonObject toJson(const Workspace::SegmentLook& look);
/// As in all views, but for what is named.
[[nodiscard]] Workspace::SegmentLook segmentLookFrom(const QJsonValue& json);
[[nodiscard]] QJsonObject toJson(const MprPlanes& planes);
void apply(const QJsonValue& json, MprPlanes& planes);
[[nodiscard]] QJsonObject toJson(const VolumeView& view);
void apply(const QJsonValue& json, VolumeView& view);

} // namespace ui::displayJson
