// SPDX-License-Identifier: Apache-2.0
#include "core/sources/DownloadCache.h"

#include <QCryptographicHash>

namespace core {

QString DownloadCache::pathOf(const QString& address, const RetrieveWish& wish) const
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const QString& part : {address, wish.studyUid, wish.seriesUid, wish.instanceUid}) {
        hash.addData(part.toUtf8());
        hash.addData(QByteArray(1, '\0'));
    }
    constexpr qsizetype letters = 32;
    return placeOf(QString::fromLatin1(hash.result().toHex().left(letters)));
}

} // namespace core
