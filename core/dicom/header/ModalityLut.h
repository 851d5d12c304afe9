// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

class DcmItem;

namespace core {

/// A table that converts stored values to modality values, instead of slope and intercept (PS3.3
/// C.11.1). Values outside the table get its first or last entry.
struct ModalityLut {
    int first = 0; ///< stored value of the first entry
    std::vector<std::uint16_t> values{}; ///< never empty

    /// @param stored values as extractStoredBits() returns them; replaced by unsigned modality
    /// values
    void apply(std::span<std::uint16_t> stored, bool isSigned) const;
};

/// Whether a data set contains such a table, be it usable or not. A sequence without an item
/// contains none.
[[nodiscard]] bool hasModalityLut(DcmItem& set);

/// The table of a data set; null if there is none that is usable. Only for sources of core/dicom.
[[nodiscard]] std::shared_ptr<const ModalityLut> readModalityLut(DcmItem& set, bool isSigned);

} // namespace core
