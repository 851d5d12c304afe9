// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <utility>

namespace core {

/// One result of a search, in the JSON model of DICOM (PS3.18 F), with values as text. What is
/// missing or malformed is empty. Tags are written "0020000D".
class JsonAnswer {
public:
    explicit JsonAnswer(QJsonObject object)
        : m_object(std::move(object))
    {
    }

    [[nodiscard]] QStringList texts(const char* tag) const;
    [[nodiscard]] QString text(const char* tag) const { return texts(tag).value(0); }
    /// −1: there is none.
    [[nodiscard]] int count(const char* tag) const;

private:
    QJsonObject m_object;
};

/// The results in what a server sent, each the object of a JsonAnswer. Errors: NodeNonsense (no
/// list in JSON).
[[nodiscard]] Result<QJsonArray> jsonAnswers(const QByteArray& bytes, const QString& nodeName);

} // namespace core
