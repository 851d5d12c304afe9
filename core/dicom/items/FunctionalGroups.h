// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace core {

/// Where a multi-frame object says something about one of its frames: among what is said of that
/// frame, else of all frames, else about the whole object, as old and legacy converted ones do
/// (PS3.3 C.7.6.16). Only for sources of core/dicom.
class FunctionalGroups {
public:
    explicit FunctionalGroups(DcmItem& dataSet);

    /// The item that holds @p macro of a frame; the data set where no group has it.
    [[nodiscard]] DcmItem& holder(const DcmTagKey& macro, std::size_t frame) const;
    /// The same, null where no group has it.
    [[nodiscard]] DcmItem* find(const DcmTagKey& macro, std::size_t frame) const;
    /// How many frames are told about one by one.
    [[nodiscard]] std::size_t count() const { return m_perFrame.size(); }

private:
    DcmItem& m_dataSet;
    DcmItem* m_shared = nullptr;
    std::vector<DcmItem*> m_perFrame{}; ///< DCMTK counts through its list for every single one
};

} // namespace core
