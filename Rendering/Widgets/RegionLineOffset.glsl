//VTK::PositionVC::Impl
  // Lines on a surface are drawn in front of it.
  gl_Position.z -= 4.0e-4 * gl_Position.w;
