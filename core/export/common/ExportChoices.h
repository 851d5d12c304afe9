// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QString>
#include <QStringList>

#include <bitset>
#include <vector>

namespace core {

/// One row of the export dialog.
struct ExportChoice {
    Segment segment;
    double millilitres = 0.0;
    bool chosen = false; ///< preselected: visible and not empty
    QStringList remarks; ///< "empty", "hidden", "surface not written back", …
};

/// All segments of the document, in its order, with the remarks of the dialog.
/// @param growing labels of segments whose growth is not at closure; export commits the burst, so
/// what has grown so far is written
[[nodiscard]] std::vector<ExportChoice> exportChoices(
    const Document& document, const std::bitset<256>& growing);

} // namespace core
