// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QJsonObject>

#include <optional>

namespace core {

/// Everything that describes a volume, including the patient's name, except its voxels and kept
/// headers. Reading it back gives the same volume bit by bit. core/session/README.md lists the
/// fields.
[[nodiscard]] QJsonObject volumeToJson(const Volume& volume);
/// None if a field on which geometry or values depend is missing or invalid.
[[nodiscard]] std::optional<Volume> volumeFromJson(const QJsonObject& json);

} // namespace core
