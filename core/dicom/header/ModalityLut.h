// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

class DcmItem;

namespace core {

/// A table that turns stored values into modality values in place of slope and intercept (PS3.3
/// C.11.1). Values beside the table get its first or last entry.
struct ModalityLut {
    int first = 0; ///< stored value of the first entry
    std::vector<std::uint16_t> values{}; ///< never empty

    /// @param stored as extractStoredBits() has them; modality values, unsigned, afterwards
    void apply(std::span<std::uint16_t> stored, bool isSigned) const;
};

/// The table of a data set; null where it is none that can be used. Only for sources of core/dicom.
[[nodiscard]] std::shared_ptr<const ModalityLut> readModalityLut(DcmItem& set, bool isSigned);

} // namespace core
