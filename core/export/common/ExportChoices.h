// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QString>
#include <QStringList>

#include <bitset>
#include <vector>

namespace core {

/// One line of the export dialog.
struct ExportChoice {
    Segment segment;
    double millilitres = 0.0;
    bool chosen = false; ///< the tick to begin with: shown and not empty
    QStringList remarks; ///< "empty", "hidden", "surface not written back", …
};

/// All segments of the document, in its order, with what the dialog says about each.
/// @param growing labels of segments whose growth has not come to closure; export closes the burst,
///        and what has grown so far is written
[[nodiscard]] std::vector<ExportChoice> exportChoices(
    const Document& document, const std::bitset<256>& growing);

} // namespace core
