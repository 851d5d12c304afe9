// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QStringList>

namespace core {

/// The files from which a volume was read, including those that a repair left out; for a folder of
/// pictures, every picture in it. Cost: reads at most one folder.
[[nodiscard]] QStringList sourceFiles(const Volume& volume);

} // namespace core
