// Which triangle is seen, for layers that know more of triangles; see TriangleRuns.h.

float hachureRun = 0.0;           // first record of the triangles to try
vec3 hachureRunPoint = vec3(0.0); // model coordinates about hachurePatchOrigin

void hachureSeeRun(float run, vec3 point)
{
  hachureRun = run;
  hachureRunPoint = point;
}
