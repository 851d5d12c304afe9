// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace core {

/// Finds what a multi-frame object states about one of its frames: in the group of that frame, else
/// in the group shared by all frames, else in the data set itself, as in old and legacy converted
/// objects (PS3.3 C.7.6.16). Only for sources of core/dicom.
class FunctionalGroups {
public:
    explicit FunctionalGroups(DcmItem& dataSet);

    /// The item that contains @p macro for a frame; the data set if no group does.
    [[nodiscard]] DcmItem& holder(const DcmTagKey& macro, std::size_t frame) const;
    /// The same, but null if no group does.
    [[nodiscard]] DcmItem* find(const DcmTagKey& macro, std::size_t frame) const;
    /// The number of frames with a group of their own.
    [[nodiscard]] std::size_t count() const { return m_perFrame.size(); }

private:
    DcmItem& m_dataSet;
    DcmItem* m_shared = nullptr;
    /// kept because DCMTK counts through its list for every single access
    std::vector<DcmItem*> m_perFrame{};
};

} // namespace core
