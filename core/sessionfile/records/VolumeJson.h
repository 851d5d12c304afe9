// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QJsonObject>

#include <optional>

namespace core {

/// All that a volume says of itself, the patient's name too, but its voxels and kept headers: the
/// same volume comes back, to the last bit. Fields are those of README.md beside this file.
[[nodiscard]] QJsonObject volumeToJson(const Volume& volume);
/// None where a field that geometry or values hang on is missing or makes no sense.
[[nodiscard]] std::optional<Volume> volumeFromJson(const QJsonObject& json);

} // namespace core
