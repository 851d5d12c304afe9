// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SourceArguments.h"

#include "ui/base/ErrorText.h"
#include "ui/settings/PacsSources.h"
#include "ui/texts/ClauseText.h"

#include <QStringList>

namespace app {

namespace {

tl::unexpected<core::Error> wrong(const char* field, const core::Clause& why)
{
    return core::failure(core::ErrorCode::InvalidField, QLatin1String(field), why);
}

core::Result<core::PacsSource> named(const QString& word)
{
    if (core::WebNode::isAddress(word) || word.contains(u'@') || word.contains(u':'))
        return core::PacsSource::parse(word);
    const std::vector<core::PacsSource> sources = ui::pacsSources();
    if (const core::PacsSource* source = core::findSource(sources, word))
        return *source;
    QStringList names;
    for (const core::PacsSource& source : sources)
        names.append(source.name);
    return wrong("node",
        QStringLiteral("'%1' is not of the form AETITLE@host:port or https://host/dicom-web, and no"
                       " source in the settings is called so%2")
            .arg(word,
                names.isEmpty()
                    ? QString()
                    : QStringLiteral(" (there are: %1)").arg(names.join(QStringLiteral(", ")))));
}

void applyOptions(const Arguments& arguments, core::PacsNode& node)
{
    if (arguments.has("own-title"))
        node.ownAeTitle = arguments.value("own-title");
    if (arguments.has("tls-authority"))
        node.tls.authorityFile = arguments.value("tls-authority");
    if (arguments.has("tls-certificate"))
        node.tls.certificateFile = arguments.value("tls-certificate");
    if (arguments.has("tls-key"))
        node.tls.keyFile = arguments.value("tls-key");
}

core::Result<void> applyOptions(const Arguments& arguments, core::WebNode& node)
{
    if (arguments.has("tls-authority"))
        node.authorityFile = arguments.value("tls-authority");
    if (arguments.has("tls-certificate"))
        node.certificateFile = arguments.value("tls-certificate");
    if (arguments.has("tls-key"))
        node.keyFile = arguments.value("tls-key");
    if (arguments.has("login-file"))
        node.loginFile = arguments.value("login-file");
    const QString login = qEnvironmentVariable("BURIN_LOGIN");
    if (!login.isEmpty() && !arguments.has("login-file")) {
        const core::Result<core::WebLogin> parsed = core::WebLogin::parse(login);
        if (!parsed)
            return wrong("BURIN_LOGIN", parsed.error().arguments.value(1));
        node.login = *parsed;
    }
    return {};
}

} // namespace

std::vector<Option> sourceOptions()
{
    return {{"own-title", "TITLE", "our application entity title; BURIN by default"},
        {"timeout", "SECONDS", "how long to wait for a sign of life; 30 by default"},
        {"login-file", "FILE",
            "a file that holds user:password or \"Bearer TOKEN\", as BURIN_LOGIN may instead"},
        {"tls-authority", "FILE",
            "speaks TLS, and trusts the certificates of this authority (PEM)"},
        {"tls-certificate", "FILE", "our own certificate (PEM)"},
        {"tls-key", "FILE", "the key of our own certificate (PEM)"}};
}

QString sourceProblem(const core::Error& error)
{
    if (error.code != core::ErrorCode::InvalidField)
        return ui::errorText(error);
    const QString field = error.arguments.value(0);
    const QString why = ui::clauseText(error.arguments.value(1));
    if (field == QLatin1String("node"))
        return QStringLiteral("SOURCE: %1").arg(why);
    // Core calls the files of TLS by what they hold.
    for (const Option& option : sourceOptions()) {
        const QLatin1String name(option.name);
        if (field == name || QStringLiteral("tls-") + field == name)
            return QStringLiteral("--%1: %2").arg(name, why);
    }
    return QStringLiteral("%1: %2").arg(field, why);
}

core::Result<core::PacsSource> sourceOf(const Arguments& arguments)
{
    if (arguments.rest().isEmpty()) {
        return wrong("node",
            QStringLiteral("AETITLE@host:port, https://host/dicom-web or a name is missing"));
    }
    core::Result<core::PacsSource> source = named(arguments.rest().first());
    if (!source)
        return source;
    const auto timeout = [&arguments](int& seconds) {
        if (arguments.has("timeout"))
            seconds = arguments.value("timeout").toInt();
    };
    if (auto* web = std::get_if<core::WebNode>(&source->node)) {
        timeout(web->timeoutSeconds);
        if (const core::Result<void> applied = applyOptions(arguments, *web); !applied)
            return tl::unexpected<core::Error>(applied.error());
        if (arguments.has("own-title"))
            return wrong("own-title", QStringLiteral("DICOMweb knows no titles"));
    } else {
        auto& node = std::get<core::PacsNode>(source->node);
        timeout(node.timeoutSeconds);
        applyOptions(arguments, node);
        if (!node.tls.wanted() && arguments.has("tls-certificate"))
            return wrong("tls-certificate", QStringLiteral("TLS needs --tls-authority as well"));
        if (node.tls.certificateFile.isEmpty() != node.tls.keyFile.isEmpty())
            return wrong("tls-key", QStringLiteral("certificate and key go together"));
        if (arguments.has("login-file"))
            return wrong("login-file", QStringLiteral("DICOM nodes know titles, no logins"));
    }
    if (const core::Result<void> sound = source->check(); !sound)
        return tl::unexpected<core::Error>(sound.error());
    return source;
}

} // namespace app
