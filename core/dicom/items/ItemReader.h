// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <array>
#include <optional>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace core {

/// Reads attributes of one DICOM item as plain data. Only for sources of core/dicom.
///
/// Numbers are parsed here and not by DCMTK, since the checks that use this must not share an error
/// with the code that they check.
class ItemReader {
public:
    explicit ItemReader(DcmItem* item)
        : m_item(item)
    {
    }

    [[nodiscard]] bool valid() const { return m_item != nullptr; }
    /// All values, joined by backslashes, without padding; as UTF-8. Empty if absent.
    [[nodiscard]] QString text(const DcmTagKey& tag) const;
    [[nodiscard]] std::optional<int> integer(const DcmTagKey& tag) const;
    [[nodiscard]] std::optional<std::array<double, 2>> pair(const DcmTagKey& tag) const;
    [[nodiscard]] std::optional<std::array<double, 3>> triple(const DcmTagKey& tag) const;
    [[nodiscard]] std::optional<std::array<double, 6>> sextuple(const DcmTagKey& tag) const;
    /// All values of decimal text; empty unless all are numbers.
    [[nodiscard]] std::vector<double> numbers(const DcmTagKey& tag) const;
    /// The values of an attribute of representation FL; empty if absent.
    [[nodiscard]] std::vector<float> floats(const DcmTagKey& tag) const;
    /// Item @p index of a sequence; invalid if there is none.
    [[nodiscard]] ItemReader item(const DcmTagKey& sequence, int index = 0) const;
    [[nodiscard]] int itemCount(const DcmTagKey& sequence) const;

    /// The first item of the functional group @p macro for a frame: per frame, else shared
    /// (PS3.3 C.7.6.16); invalid if there is neither.
    [[nodiscard]] ItemReader functionalGroup(const DcmTagKey& macro, int frame) const;

private:
    template <std::size_t N>
    std::optional<std::array<double, N>> exactly(const DcmTagKey& tag) const;

    DcmItem* m_item = nullptr;
};

} // namespace core
