// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/NewUid.h"

#include <QUuid>

#include <algorithm>

namespace core {

QString uidOf(QByteArray bytes)
{
    // Long division of the 128 bits by ten.
    QString digits;
    while (std::any_of(bytes.begin(), bytes.end(), [](char byte) { return byte != 0; })) {
        int remainder = 0;
        for (char& byte : bytes) {
            const int value = remainder * 256 + int(static_cast<unsigned char>(byte));
            byte = char(value / 10);
            remainder = value % 10;
        }
        digits.prepend(QChar(u'0' + remainder));
    }
    return QStringLiteral("2.25.") + (digits.isEmpty() ? QStringLiteral("0") : digits);
}

QString newUid()
{
    return uidOf(QUuid::createUuid().toRfc4122());
}

} // namespace core
