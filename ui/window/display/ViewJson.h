// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/SliceTurn.h"
#include "ui/views/MprPlanes.h"
#include "ui/views/SliceView.h"

#include <QJsonObject>
#include <QJsonValue>
#include <QString>

#include <optional>

namespace ui {
class VolumeView;
} // namespace ui

/// Position of views and drawing of slices as JSON, as DisplayState saves it in a session. Reading
/// leaves a target unchanged where the JSON has no valid value.
namespace ui::displayJson {

[[nodiscard]] QString nameOf(gpu::SlabMode mode);
/// The mode with a name; Off if there is none.
[[nodiscard]] gpu::SlabMode slabNamed(const QString& name);
[[nodiscard]] QString nameOf(gpu::ColourMap map);
/// The colour map with a name; Grey if there is none.
[[nodiscard]] gpu::ColourMap coloursNamed(const QString& name);
[[nodiscard]] QString nameOf(gpu::Interpolation interpolation);
/// The interpolation with a name; none if there is none, which is the usual way.
[[nodiscard]] std::optional<gpu::Interpolation> interpolationNamed(const QString& name);

[[nodiscard]] QJsonObject toJson(const SliceView::Place& place);
void apply(const QJsonValue& json, SliceView& view);
[[nodiscard]] QJsonObject toJson(const SliceTurn& turn);
void read(const QJsonValue& json, SliceTurn& turn);
[[nodiscard]] QJsonObject toJson(const Workspace::SegmentLook& look);
/// The look that the JSON names; what it does not name is as in all views.
[[nodiscard]] Workspace::SegmentLook segmentLookFrom(const QJsonValue& json);
[[nodiscard]] QJsonObject toJson(const MprPlanes& planes);
void apply(const QJsonValue& json, MprPlanes& planes);
[[nodiscard]] QJsonObject toJson(const VolumeView& view);
void apply(const QJsonValue& json, VolumeView& view);

} // namespace ui::displayJson
