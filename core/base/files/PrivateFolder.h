// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// Creates a folder, with missing parents, that only its owner can read, since names of studies and
/// sessions reveal who was treated. An existing folder is made private. @return whether it exists
bool makePrivateFolder(const QString& path);

/// The same for a file, which is created empty if it is missing. errno has the reason if it fails.
bool makePrivateFile(const QString& path);

} // namespace core
