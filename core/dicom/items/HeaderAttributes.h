// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace core {

/// Typed access to the attributes of one item. Only for sources of core/dicom. The checks of
/// exports use ItemReader instead, which shares no code with it.
class HeaderAttributes {
public:
    /// @param characterSet SpecificCharacterSet of the data set
    HeaderAttributes(DcmItem& item, const QByteArray& characterSet)
        : m_item(item)
        , m_characterSet(characterSet)
    {
    }

    /// All values joined by backslashes; empty if the attribute is absent.
    [[nodiscard]] QByteArray bytes(const DcmTagKey& key) const;
    [[nodiscard]] QString text(const DcmTagKey& key) const;
    /// US
    [[nodiscard]] int integer(const DcmTagKey& key, int otherwise = 0) const;
    /// DS, IS, FD …; empty unless all are numbers.
    [[nodiscard]] std::vector<double> numbers(const DcmTagKey& key) const;
    [[nodiscard]] std::optional<double> number(const DcmTagKey& key) const;
    [[nodiscard]] bool has(const DcmTagKey& key) const;

private:
    DcmItem& m_item;
    QByteArray m_characterSet;
};

} // namespace core
