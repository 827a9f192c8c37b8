// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Puts Hachure's text into VTK's polydata shaders, at VTK's own replacement tags.
 *
 * VTK asks every render pass in an actor's property keys for replacements, before and after its
 * own. Before, markers are placed; after, they are filled in, when the finished text tells how the
 * surface is lit. A tag that is not there is an error, never a silently different picture.
 */
#ifndef vtkPatternShaderInjector_h
#define vtkPatternShaderInjector_h

#include "vtkOpenGLRenderPass.h"
#include "vtkPatternAttributes.h"
#include "vtkPatternToneChannels.h"

#include <functional>
#include <string>

class vtkPatternShaderInjector : public vtkOpenGLRenderPass
{
public:
  static vtkPatternShaderInjector* New();
  vtkTypeMacro(vtkPatternShaderInjector, vtkOpenGLRenderPass);

  /// ATTRIBUTES writes what the screen pass needs, PEEL the same behind a depth (see
  /// vtkPatternTonePeel), FORWARD draws the layers in the surface shader.
  enum StageType
  {
    ATTRIBUTES,
    PEEL,
    FORWARD
  };

  /// What to inject; a change makes VTK build the shader anew.
  void Configure(StageType stage, const vtkPatternToneChannels& channels, std::size_t lights,
    bool flatPaper, const vtkPatternAttributes& attributes, const std::string& composeText);

  /// Sets the values of our uniforms whenever a program is used.
  std::function<void(vtkShaderProgram*)> UniformSetter;

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao) override;
  vtkMTimeType GetShaderStageMTime() override { return this->ConfigureTime.GetMTime(); }

protected:
  vtkPatternShaderInjector() = default;
  ~vtkPatternShaderInjector() override = default;

private:
  bool Place(std::string& shader, const std::string& tag, const std::string& text);
  /// lit, lighting: whether VTK lights the surface, and whether its property wants that.
  std::string ToneText(bool lit, bool lighting) const;
  std::string LightText(const std::string& section, std::size_t channel) const;
  std::string LightsDeclaration() const;
  /// The pieces of what the layers need of the surface: sections with this ending.
  std::string SurfaceText(const std::string& ending) const;
  std::string SurfaceValues() const;
  bool DrawsIds() const { return this->Stage == FORWARD && this->Needed.PrimitiveIds; }
  std::string SurfaceOutputs() const;
  std::string StageText(bool colors) const;

  StageType Stage = ATTRIBUTES;
  vtkPatternToneChannels Channels;
  std::size_t Lights = 0; // of the scene, where a tone follows them
  bool FlatPaper = false;
  vtkPatternAttributes Needed;
  std::string ComposeText;
  vtkTimeStamp ConfigureTime;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternShaderInjector.h
