// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/Program.h"

#include "gpu/gl/GlFailure.h"
#include "gpu/gl/GpuTrace.h"

#include <glm/gtc/type_ptr.hpp>

#include <QByteArray>

#include <algorithm>
#include <array>

namespace gpu {

namespace {

using Shader = GlId<glDelete::shader>;

Shader compile(
    GLenum stage, const ShaderLibrary& library, const char* path, const ShaderDefines& defines)
{
    const ShaderSource source = library.load(QString::fromLatin1(path), defines);
    Shader shader(glCreateShader(stage));
    labelObject(GL_SHADER, shader.get(), path);
    const char* text = source.text.constData();
    glShaderSource(shader.get(), 1, &text, nullptr);
    glCompileShader(shader.get());
    GLint compiled = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        requireMemory(path);
        GLint length = 0;
        glGetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &length);
        QByteArray log(length, '\0');
        glGetShaderInfoLog(shader.get(), length, nullptr, log.data());
        throw ShaderError(source.withFileNames(QString::fromUtf8(log.constData())));
    }
    return shader;
}

} // namespace

Program::Program(const ShaderLibrary& library, const ComputeProgramOptions& options)
{
    const Shader shader = compile(GL_COMPUTE_SHADER, library, options.path, options.defines);
    link(options.label, std::array{shader.get()});
}

Program::Program(const ShaderLibrary& library, const GraphicsProgramOptions& options)
{
    const Shader vertex = compile(GL_VERTEX_SHADER, library, options.vertexPath, options.defines);
    const Shader fragment =
        compile(GL_FRAGMENT_SHADER, library, options.fragmentPath, options.defines);
    link(options.label, std::array{vertex.get(), fragment.get()});
}

void Program::link(const char* label, std::span<const GLuint> shaders)
{
    m_id = GlId<glDelete::program>(glCreateProgram());
    m_label = label;
    labelObject(GL_PROGRAM, id(), label);
    for (const GLuint shader : shaders)
        glAttachShader(id(), shader);
    glLinkProgram(id());
    for (const GLuint shader : shaders)
        glDetachShader(id(), shader);
    GLint linked = 0;
    glGetProgramiv(id(), GL_LINK_STATUS, &linked);
    if (linked == 0) {
        requireMemory(label);
        GLint length = 0;
        glGetProgramiv(id(), GL_INFO_LOG_LENGTH, &length);
        QByteArray log(length, '\0');
        glGetProgramInfoLog(id(), length, nullptr, log.data());
        throw ShaderError(
            QString::fromUtf8(label) + QStringLiteral(": ") + QString::fromUtf8(log.constData()));
    }
    GLint count = 0;
    glGetProgramiv(id(), GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < GLuint(count); ++i) {
        std::array<char, 256> name{};
        GLint arraySize = 0;
        GLenum type = 0;
        glGetActiveUniform(id(), i, GLsizei(name.size()), nullptr, &arraySize, &type, name.data());
        std::string text = name.data();
        const GLint location = glGetUniformLocation(id(), text.c_str());
        if (text.ends_with("[0]"))
            text.resize(text.size() - 3);
        if (location >= 0)
            m_uniforms.push_back({text, location});
    }
    std::sort(m_uniforms.begin(), m_uniforms.end(),
        [](const Uniform& a, const Uniform& b) { return a.name < b.name; });
}

GLint Program::location(std::string_view name) const
{
    const auto found = std::lower_bound(m_uniforms.begin(), m_uniforms.end(), name,
        [](const Uniform& uniform, std::string_view wanted) { return uniform.name < wanted; });
    return found != m_uniforms.end() && found->name == name ? found->location : -1;
}

Program& Program::set(std::string_view name, bool value)
{
    return set(name, int(value));
}

Program& Program::set(std::string_view name, int value)
{
    glProgramUniform1i(id(), location(name), value);
    return *this;
}

Program& Program::set(std::string_view name, unsigned value)
{
    glProgramUniform1ui(id(), location(name), value);
    return *this;
}

Program& Program::set(std::string_view name, float value)
{
    glProgramUniform1f(id(), location(name), value);
    return *this;
}

Program& Program::set(std::string_view name, const glm::ivec2& value)
{
    glProgramUniform2iv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::ivec3& value)
{
    glProgramUniform3iv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::ivec4& value)
{
    glProgramUniform4iv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::uvec2& value)
{
    glProgramUniform2uiv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::uvec3& value)
{
    glProgramUniform3uiv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::uvec4& value)
{
    glProgramUniform4uiv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::vec2& value)
{
    glProgramUniform2fv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::vec3& value)
{
    glProgramUniform3fv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::vec4& value)
{
    glProgramUniform4fv(id(), location(name), 1, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::mat3& value)
{
    glProgramUniformMatrix3fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, const glm::mat4& value)
{
    glProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
    return *this;
}

Program& Program::set(std::string_view name, std::span<const int> values)
{
    glProgramUniform1iv(id(), location(name), GLsizei(values.size()), values.data());
    return *this;
}

Program& Program::set(std::string_view name, std::span<const unsigned> values)
{
    glProgramUniform1uiv(id(), location(name), GLsizei(values.size()), values.data());
    return *this;
}

Program& Program::set(std::string_view name, const std::bitset<256>& labels)
{
    std::array<unsigned, 8> words{};
    for (std::size_t label = 0; label < labels.size(); ++label)
        words[label / 32] |= unsigned(labels[label]) << (label % 32);
    return set(name, std::span<const unsigned>(words));
}

Program& Program::set(std::string_view name, std::span<const float> values)
{
    glProgramUniform1fv(id(), location(name), GLsizei(values.size()), values.data());
    return *this;
}

Program& Program::set(std::string_view name, std::span<const glm::vec4> values)
{
    glProgramUniform4fv(
        id(), location(name), GLsizei(values.size()), glm::value_ptr(values.front()));
    return *this;
}

Program& Program::set(std::string_view name, std::span<const glm::ivec4> values)
{
    glProgramUniform4iv(
        id(), location(name), GLsizei(values.size()), glm::value_ptr(values.front()));
    return *this;
}

void Program::use() const
{
    glUseProgram(id());
    GpuTrace::use(m_label);
}

void Program::dispatch(const glm::uvec3& groups) const
{
    use();
    const GpuTrace::Span measured;
    glDispatchCompute(groups.x, groups.y, groups.z);
}

void Program::dispatchIndirect(const Buffer& groups, std::size_t offset) const
{
    use();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.id());
    const GpuTrace::Span measured;
    glDispatchComputeIndirect(GLintptr(offset));
}

} // namespace gpu
