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

/// How the 3D view, the cutting plane, pieces and layers look, as a session keeps it
/// (DisplayState). Reading leaves the target alone where there is nothing sensible.
namespace ui::displayJson {

[[nodiscard]] QJsonArray toJson(const glm::dvec3& point);
void read(const QJsonValue& json, glm::dvec3& point);
[[nodiscard]] QJsonObject toJson(const core::WindowLevel& window);
void read(const QJsonValue& json, core::WindowLevel& window);
/// Whether both are unit vectors, perpendicular to each other.
[[nodiscard]] bool atRightAngles(const glm::dvec3& a, const glm::dvec3& b);

/// Empty: none.
[[nodiscard]] QString nameOf(std::optional<gpu::Context> context);
[[nodiscard]] std::optional<gpu::Context> contextNamed(const QString& name);
[[nodiscard]] QJsonObject toJson(const Workspace::VolumeDisplay& display);
void read(const QJsonValue& json, Workspace::VolumeDisplay& display);

[[nodiscard]] QJsonObject toJson(const core::ClipRegion& clip);
/// @param whole the greatest box
void read(const QJsonValue& json, const core::ClipRegion& whole, core::ClipRegion& clip);

[[nodiscard]] QJsonObject toJson(const CuttingPlane& plane);
void apply(const QJsonValue& json, CuttingPlane& plane);
[[nodiscard]] QJsonArray toJson(const std::map<int, PieceLook>& looks);
void apply(const QJsonValue& json, Pieces& pieces);
[[nodiscard]] QJsonArray toJson(const std::map<int, LayerLook>& looks);
void apply(const QJsonValue& json, LayerLooks& layers);

/// Of segments: percent by label.
[[nodiscard]] QJsonArray opacitiesToJson(const std::map<int, int>& opacities);
[[nodiscard]] std::map<int, int> opacitiesFrom(const QJsonValue& json);

} // namespace ui::displayJson
