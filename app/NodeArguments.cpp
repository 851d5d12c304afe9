// SPDX-License-Identifier: Apache-2.0
#include "app/NodeArguments.h"

namespace app {

QStringList nodeOptions(const QStringList& more)
{
    return more
        + QStringList{QStringLiteral("own-title"), QStringLiteral("timeout"),
            QStringLiteral("tls-authority"), QStringLiteral("tls-certificate"),
            QStringLiteral("tls-key")};
}

core::Result<core::PacsNode> nodeOf(const Arguments& arguments)
{
    if (arguments.rest().isEmpty()) {
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("node"),
            QStringLiteral("AETITLE@host:port is missing"));
    }
    core::Result<core::PacsNode> node = core::PacsNode::parse(arguments.rest().first());
    if (!node)
        return node;
    if (arguments.has("own-title"))
        node->ownAeTitle = arguments.value("own-title");
    if (arguments.has("timeout"))
        node->timeoutSeconds = arguments.value("timeout").toInt();
    node->tls = {.authorityFile = arguments.value("tls-authority"),
        .certificateFile = arguments.value("tls-certificate"),
        .keyFile = arguments.value("tls-key")};
    if (!node->tls.wanted() && arguments.has("tls-certificate")) {
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("tls-certificate"),
            QStringLiteral("TLS needs --tls-authority as well"));
    }
    if (node->tls.certificateFile.isEmpty() != node->tls.keyFile.isEmpty()) {
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("tls-key"),
            QStringLiteral("certificate and key go together"));
    }
    if (const core::Result<void> sound = node->check(); !sound)
        return tl::unexpected<core::Error>(sound.error());
    return node;
}

} // namespace app
