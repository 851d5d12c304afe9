// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/DisplayJson.h"
#include "ui/workspace/Workspace.h"

#include <QJsonArray>
#include <QJsonObject>

#include <map>
#include <optional>

namespace ui {
struct LayerLook;
struct PieceLook;
} // namespace ui

/// The look of the 3D view, cutting plane, pieces and sculpt layers as JSON, as DisplayState saves
/// it in a session. Reading leaves a target unchanged where the JSON has no valid value.
namespace ui::displayJson {

[[nodiscard]] QJsonArray toJson(const glm::dvec3& point);
void read(const QJsonValue& json, glm::dvec3& point);
[[nodiscard]] QJsonObject toJson(const core::WindowLevel& window);
void read(const QJsonValue& json, core::WindowLevel& window);
/// Whether both are unit vectors and perpendicular to each other.
[[nodiscard]] bool atRightAngles(const glm::dvec3& a, const glm::dvec3& b);

/// The name of a context; empty for none.
[[nodiscard]] QString nameOf(std::optional<gpu::Context> context);
[[nodiscard]] std::optional<gpu::Context> contextNamed(const QString& name);
[[nodiscard]] QJsonObject toJson(const Workspace::VolumeDisplay& display);
void read(const QJsonValue& json, Workspace::VolumeDisplay& display);

[[nodiscard]] QJsonObject toJson(const core::ClipRegion& clip);
/// @param whole the box is clamped to this one
void read(const QJsonValue& json, const core::ClipRegion& whole, core::ClipRegion& clip);

[[nodiscard]] QJsonObject toJson(const CuttingPlane& plane);
void apply(const QJsonValue& json, CuttingPlane& plane);
[[nodiscard]] QJsonArray toJson(const std::map<int, PieceLook>& looks);
void apply(const QJsonValue& json, Pieces& pieces);
[[nodiscard]] QJsonArray toJson(const std::map<int, LayerLook>& looks);
void apply(const QJsonValue& json, LayerLooks& layers);

/// Opacities of segments in per cent, by label.
[[nodiscard]] QJsonArray opacitiesToJson(const std::map<int, int>& opacities);
[[nodiscard]] std::map<int, int> opacitiesFrom(const QJsonValue& json);

} // namespace ui::displayJson
