// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// Makes a folder, with those above it where they are missing, that its owner alone can look into:
/// names of studies and sessions tell who was treated. One that is there becomes so. @return
/// whether it is there
bool makePrivateFolder(const QString& path);

/// The same of a file, which is made empty where it is missing.
bool makePrivateFile(const QString& path);

} // namespace core
