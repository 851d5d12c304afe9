// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace core {

/// Typed look at one item of a data set. Only for sources of core/dicom; the checks of exports read
/// by ItemReader, which shares nothing with it.
class HeaderAttributes {
public:
    /// @param characterSet SpecificCharacterSet of the data set
    HeaderAttributes(DcmItem& item, const QByteArray& characterSet)
        : m_item(item)
        , m_characterSet(characterSet)
    {
    }

    /// All values joined by backslashes; empty where the attribute is absent.
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
