// SPDX-License-Identifier: Apache-2.0
#include "gpu/shaders/ShaderLibrary.h"

#include <QFile>
#include <QRegularExpression>

// Resources of a static library are registered by this call only; it must stand outside namespaces.
static void registerShaders()
{
    Q_INIT_RESOURCE(burin_shaders);
}

namespace gpu {

namespace {

QByteArray lineDirective(int nextLine, int file)
{
    return "#line " + QByteArray::number(nextLine) + ' ' + QByteArray::number(file) + '\n';
}

} // namespace

QString ShaderSource::withFileNames(const QString& driverLog) const
{
    // Mesa "0:12(5): error", AMD and ANGLE "ERROR: 0:12: …", NVIDIA "0(12) : error".
    static const QRegularExpression place(
        QStringLiteral(R"((?<![\w.])(\d+)(?::(\d+)(\(\d+\))?|\((\d+)\)))"));
    QString result;
    qsizetype copied = 0;
    auto matches = place.globalMatch(driverLog);
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        const int file = match.captured(1).toInt();
        if (file >= files.size())
            continue;
        const QString line = match.captured(2).isEmpty() ? match.captured(4) : match.captured(2);
        result += QStringView(driverLog).mid(copied, match.capturedStart() - copied);
        result += files[file] + QLatin1Char(':') + line;
        copied = match.capturedEnd();
    }
    return result + driverLog.mid(copied);
}

ShaderLibrary ShaderLibrary::builtIn()
{
    registerShaders();
    return ShaderLibrary(QStringLiteral(":/shaders"));
}

ShaderLibrary::ShaderLibrary(QString root)
    : m_root(std::move(root))
{
}

ShaderSource ShaderLibrary::load(const QString& path, const ShaderDefines& defines) const
{
    ShaderSource source;
    source.text = "#version 450 core\n";
    for (const auto& [name, value] : defines)
        source.text += QByteArray("#define ") + name + ' ' + QByteArray::number(value) + '\n';
    QStringList chain;
    QStringList once;
    append(path, chain, once, source);
    return source;
}

void ShaderLibrary::append(
    const QString& path, QStringList& chain, QStringList& once, ShaderSource& source) const
{
    QFile file(m_root + QLatin1Char('/') + path);
    if (!file.open(QIODevice::ReadOnly)) {
        const QString from = chain.isEmpty() ? QString() : chain.last() + QStringLiteral(": ");
        throw ShaderError(from + QStringLiteral("cannot read shader ") + path);
    }
    chain.append(path);
    once.append(path);
    const int number = int(source.files.size());
    source.files.append(path);
    source.text += lineDirective(1, number);

    static const QRegularExpression include(QStringLiteral(R"(^\s*#\s*include\s+"([^"]+)\"\s*$)"));
    int line = 0;
    for (const QByteArray& text : file.readAll().split('\n')) {
        ++line;
        const QRegularExpressionMatch match = include.match(QString::fromUtf8(text));
        if (!match.hasMatch()) {
            source.text += text + '\n';
            continue;
        }
        const QString wanted = match.captured(1);
        if (chain.contains(wanted)) {
            throw ShaderError(
                QStringLiteral("%1:%2: include cycle: %3 → %4")
                    .arg(path, QString::number(line), chain.join(QStringLiteral(" → ")), wanted));
        }
        if (!once.contains(wanted))
            append(wanted, chain, once, source);
        source.text += lineDirective(line + 1, number);
    }
    chain.removeLast();
}

} // namespace gpu
