// Many of one shape as one mesh, and the picture of what belongs to the ground.
import {
  CanvasTexture, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, RepeatWrapping, Vector3,
} from 'three';

export const thin = 0.007, round = 0.013;  // radii of links and joints, of the mechanism's size
const up = new Vector3(0, 1, 0);   // of a cylinder
const [a, b, way, middle, scale] = Array.from({length: 5}, () => new Vector3());
const turn = new Quaternion(), matrix = new Matrix4();

// Many of one shape, each placed anew in every frame.
export class Instances {
  constructor(scene, geometry, count, material = new MeshLambertMaterial()) {
    this.mesh = new InstancedMesh(geometry, material, Math.max(1, count));
    this.mesh.count = count;
    this.mesh.frustumCulled = false;
    scene.add(this.mesh);
  }
  colour(k, colour) { this.mesh.setColorAt(k, colour); }
  // A cylinder from one point to another.
  between(k, from, to, radius) {
    way.subVectors(to, from);
    this.along(k, middle.addVectors(from, to).multiplyScalar(0.5), way, way.length(), radius);
  }
  // A shape about a point, its y axis along a direction.
  along(k, middle, direction, length, radius) {
    a.copy(middle);
    turn.setFromUnitVectors(up, b.copy(direction).normalize());
    matrix.compose(a, turn, scale.set(radius, length, radius));
    this.mesh.setMatrixAt(k, matrix);
  }
  hide(k) { this.mesh.setMatrixAt(k, matrix.makeScale(0, 0, 0)); }
  done() { this.mesh.instanceMatrix.needsUpdate = true; }
}

// Stripes for what belongs to the ground.
export function hatching() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const c = canvas.getContext('2d');
  c.strokeStyle = '#888';
  c.lineWidth = 5;
  for (const x of [-32, 0, 32]) {
    c.beginPath();
    c.moveTo(x - 4, 36), c.lineTo(x + 36, -4);
    c.stroke();
  }
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.repeat.set(3, 3);
  return texture;
}
