// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebConnection.h"

#include <QByteArray>
#include <QString>

#include <utility>

namespace core {

/// Collects a JSON answer up to a length limit. @p mayBeOther: any other content is accepted too
class JsonSink : public WebSink {
public:
    JsonSink(QString nodeName, bool mayBeOther)
        : m_nodeName(std::move(nodeName))
        , m_mayBeOther(mayBeOther)
    {
    }
    [[nodiscard]] Result<void> begin(const WebAnswer& answer) override;
    [[nodiscard]] Result<void> take(const QByteArray& bytes) override;
    [[nodiscard]] const QByteArray& bytes() const { return m_bytes; }

private:
    QString m_nodeName;
    bool m_mayBeOther;
    QByteArray m_bytes;
};

} // namespace core
