// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/JsonSink.h"

namespace core {

namespace {

/// No list of studies, series or objects is longer.
constexpr qsizetype longestJson = 64 << 20;

} // namespace

Result<void> JsonSink::begin(const WebAnswer& answer)
{
    m_bytes.clear();
    if (m_mayBeOther || answer.status == 204 || answer.contentType.contains("json"))
        return {};
    return failure(ErrorCode::NodeNonsense, m_nodeName,
        Clause::saying("it answers with '%1' where DICOM JSON was asked for",
            QString::fromLatin1(answer.contentType.left(60))));
}

Result<void> JsonSink::take(const QByteArray& bytes)
{
    if (m_bytes.size() + bytes.size() > longestJson) {
        return failure(
            ErrorCode::NodeNonsense, m_nodeName, Clause::saying("its answer has no end"));
    }
    m_bytes += bytes;
    return {};
}

} // namespace core
