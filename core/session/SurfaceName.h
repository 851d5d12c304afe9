// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/Edits.h"
#include "core/engine/EngineCommands.h"

#include <QString>

namespace core {

/// The name of a row that works on the surface (RowName.h); empty for other edits.
/// @param document before it
[[nodiscard]] QString surfaceRowName(
    const Edit& edit, const EditStatistics& statistics, const Document& document);

} // namespace core
