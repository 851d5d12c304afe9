// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/ChangeFacts.h"

#include <QString>

namespace core {

/// Names of rows (RowName.h): "Divide around 'Liver' into chunks, 10.0 mm".
[[nodiscard]] QString chunksName(const Chunks& edit, const Document& document);
/// "Add chunks to 'Liver', +18 204 −310 voxels"
[[nodiscard]] QString chunksName(
    const ChunkToggle& edit, const ChangeFacts& facts, const Document& document);

} // namespace core
