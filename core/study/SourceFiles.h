// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QStringList>

namespace core {

/// The files that a volume was read from, also those that a repaired series left out; of a folder
/// of pictures every picture in it. Cost: at most one look into a folder.
[[nodiscard]] QStringList sourceFiles(const Volume& volume);

} // namespace core
