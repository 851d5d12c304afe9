// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/JsonAnswer.h"

#include <QJsonDocument>

namespace core {

QStringList JsonAnswer::texts(const char* tag) const
{
    QStringList all;
    const QJsonArray values = m_object[QLatin1String(tag)].toObject()[u"Value"].toArray();
    for (const QJsonValue& value : values) {
        // Names come in groups; numbers as numbers, or by some servers as text.
        const QJsonValue plain =
            value.isObject() ? value.toObject()[u"Alphabetic"] : QJsonValue(value);
        all.append(plain.toVariant().toString().trimmed());
    }
    return all;
}

int JsonAnswer::count(const char* tag) const
{
    bool isNumber = false;
    const int number = text(tag).toInt(&isNumber);
    return isNumber && number >= 0 ? number : -1;
}

Result<QJsonArray> jsonAnswers(const QByteArray& bytes, const QString& nodeName)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
    if (!document.isArray()) {
        return failure(ErrorCode::NodeNonsense, nodeName,
            Clause::saying("its answer is no list in JSON (%1)", error.errorString()));
    }
    return document.array();
}

} // namespace core
