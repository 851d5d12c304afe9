// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsNode.h"

#include <algorithm>

namespace core {

namespace {

bool isAeTitle(const QString& text)
{
    const bool printable = std::all_of(text.begin(), text.end(), [](QChar character) {
        return character >= u' ' && character <= u'~' && character != u'\\';
    });
    return printable && text.size() <= 16 && !text.trimmed().isEmpty();
}

} // namespace

QString PacsNode::name() const
{
    return QStringLiteral("%1@%2:%3").arg(aeTitle, host).arg(port);
}

Result<PacsNode> PacsNode::parse(const QString& text)
{
    // A title may hold an @, a host may not; colons of an IPv6 address stand before the port's.
    const qsizetype at = text.lastIndexOf(u'@');
    const qsizetype colon = text.lastIndexOf(u':');
    if (at < 1 || colon < at + 2) {
        return failure(ErrorCode::InvalidField, QStringLiteral("node"),
            Clause::saying("'%1' is not of the form AETITLE@host:port", text));
    }
    PacsNode node;
    node.aeTitle = text.left(at);
    node.host = text.mid(at + 1, colon - at - 1);
    node.port = text.mid(colon + 1).toInt();
    if (const Result<void> sound = node.check(); !sound)
        return tl::unexpected<Error>(sound.error());
    return node;
}

Result<void> PacsNode::check() const
{
    for (const QString& title : {aeTitle, ownAeTitle}) {
        if (!isAeTitle(title)) {
            return failure(ErrorCode::InvalidField, QStringLiteral("AE title"),
                Clause::saying("'%1' is not 1 to 16 characters of ASCII", title));
        }
    }
    if (host.isEmpty() || port < 1 || port > 65535) {
        return failure(ErrorCode::InvalidField, QStringLiteral("node"),
            Clause::saying("'%1' names no host and port", name()));
    }
    if (timeoutSeconds < 1) {
        return failure(ErrorCode::InvalidField, QStringLiteral("timeout"),
            Clause::saying("it is 1 second or more"));
    }
    // Who names a certificate means a secured connection, and would not get one.
    if (!tls.wanted() && !(tls.certificateFile.isEmpty() && tls.keyFile.isEmpty())) {
        return failure(ErrorCode::InvalidField, QStringLiteral("authority"),
            Clause::saying("without it the connection would not be encrypted"));
    }
    if (tls.certificateFile.isEmpty() != tls.keyFile.isEmpty()) {
        return failure(ErrorCode::InvalidField, QStringLiteral("key"),
            Clause::saying("certificate and key go together"));
    }
    return {};
}

} // namespace core
