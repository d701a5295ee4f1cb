/**
 * The window onto the model: renderer, camera, light, and what is drawn on demand. Nothing is drawn while nothing changes.
 */

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { THEMES, type Theme } from "./palette";

/** A moving picture that takes longer than this, in milliseconds, is drawn with less; after this pause it moves no more. */
const SLOW = 80;
const PAUSE = 250;

export class Stage {
  readonly scene = new THREE.Scene();
  readonly camera: THREE.OrthographicCamera | THREE.PerspectiveCamera;
  controls: OrbitControls;
  /** What is beyond this plane is not drawn. */
  readonly clip = new THREE.Plane(new THREE.Vector3(-1, 0, 0), 1e30);
  /** null where the browser has no WebGL: then whoever draws still pictures is asked for one. */
  private readonly renderer: THREE.WebGLRenderer | null;
  private readonly lineMaterials = new Set<LineMaterial>();
  /** When the picture moved last, and when it was drawn last; how many moving pictures in a row took long. */
  private movedAt = -Infinity;
  private drawnAt = -Infinity;
  private slow = 0;
  private isHurried = false;
  private hurry: ((isHurried: boolean) => void) | null = null;
  private isWaiting = false;
  private listeners: (() => void)[] = [];

  constructor(
    private readonly canvas: HTMLCanvasElement,
    readonly isFlat: boolean,
    readonly center: THREE.Vector3,
    readonly radius: number,
  ) {
    this.renderer = rendererOf(canvas);
    this.renderer?.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    if (this.renderer) this.renderer.localClippingEnabled = true;
    const reach = Math.max(radius, 1e-30);
    if (isFlat) {
      this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -100 * reach, 100 * reach);
    } else {
      this.camera = new THREE.PerspectiveCamera(35, 1, reach / 1000, reach * 100);
    }
    this.controls = this.controlsOf();
    const key = new THREE.DirectionalLight(0xffffff, 2.2);
    key.position.set(0.4, 0.7, 1);
    this.camera.add(key);
    const fill = new THREE.DirectionalLight(0xffffff, 0.8);
    fill.position.set(-0.8, -0.3, 0.6);
    this.camera.add(fill);
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, 0.7));
    this.reset();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  /** What the mouse and fingers do; it turns around the direction that is up when it is made. */
  private controlsOf(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = false;
    controls.screenSpacePanning = true;
    if (this.isFlat) {
      controls.enableRotate = false;
      controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
      controls.touches.ONE = THREE.TOUCH.PAN;
    }
    controls.addEventListener("change", () => {
      this.movedAt = performance.now();
      this.draw();
    });
    return controls;
  }

  /** Which axis is up: y, as in pictures, or z, as on maps and drawings of machines. */
  get isUpZ(): boolean {
    return this.camera.up.z === 1;
  }

  setUpZ(isUpZ: boolean): void {
    if (this.isFlat || isUpZ === this.isUpZ) return;
    this.camera.up.set(0, isUpZ ? 0 : 1, isUpZ ? 1 : 0);
    const { target } = this.controls;
    this.controls.dispose();
    this.controls = this.controlsOf();
    this.controls.target.copy(target);
    this.reset();
  }

  /** Turns a direction in which y is up into one where the axis is up that is. */
  upright(direction: THREE.Vector3): THREE.Vector3 {
    return this.isUpZ ? new THREE.Vector3(direction.x, -direction.z, direction.y) : direction;
  }

  /** Turns around what is looked at, by angles in radians. */
  turn(around: number, over: number): void {
    const { camera, controls } = this;
    const arm = camera.position.clone().sub(controls.target);
    const toY = new THREE.Quaternion().setFromUnitVectors(camera.up, new THREE.Vector3(0, 1, 0));
    const place = new THREE.Spherical().setFromVector3(arm.applyQuaternion(toY));
    place.theta += around;
    place.phi = Math.min(Math.max(place.phi - over, 0.01), Math.PI - 0.01);
    arm.setFromSpherical(place).applyQuaternion(toY.invert());
    camera.position.copy(controls.target).add(arm);
  }

  /** Lines of a width in pixels. */
  lineMaterial(color: string, width: number): LineMaterial {
    const material = new LineMaterial({ color, linewidth: width, clippingPlanes: this.planes });
    this.lineMaterials.add(material);
    material.resolution.set(this.canvas.clientWidth, this.canvas.clientHeight);
    return material;
  }

  /** The cutting planes of what is drawn over the model; none where 3-cells are left out whole. */
  planes: THREE.Plane[] = [this.clip];

  /** A material that was thrown away needs to know the size of the window no more. */
  forget(material: THREE.Material): void {
    this.lineMaterials.delete(material as LineMaterial);
  }

  /** Whether the picture is drawn by the graphics processor, or by a program that stands in for one. */
  get hasRenderer(): boolean {
    return this.renderer !== null;
  }

  setTheme(theme: Theme): void {
    this.renderer?.setClearColor(THEMES[theme].background);
    this.draw();
  }

  /** The first view again. */
  reset(): void {
    this.look(this.center, this.radius, this.isFlat ? new THREE.Vector3(0, 0, 1) : this.upright(new THREE.Vector3(0.5, 0.35, 1)));
  }

  /** Looks at a ball from a direction, or from where the camera is. */
  look(center: THREE.Vector3, radius: number, from?: THREE.Vector3): void {
    const direction = (from ?? this.camera.position.clone().sub(this.controls.target)).clone().normalize();
    // What is small is seen with what is around it.
    const reach = Math.max(radius, this.radius * 0.08, 1e-30);
    this.controls.target.copy(center);
    if (this.camera instanceof THREE.PerspectiveCamera) {
      // The ball is as wide as it is high, but windows are not.
      const half = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2)) * Math.min(this.aspect, 1);
      const distance = (1.05 * reach) / Math.sin(Math.atan(half));
      this.camera.position.copy(center).addScaledVector(direction, distance);
    } else {
      this.camera.position.copy(center).addScaledVector(direction, 10 * this.radius);
      this.camera.zoom = 1;
      this.halfHeight = (1.1 * reach) / Math.min(this.aspect, 1);
    }
    this.resize();
    this.controls.update();
    this.draw();
  }

  private halfHeight = 1;

  private get aspect(): number {
    const parent = this.canvas.parentElement;
    return Math.max(parent?.clientWidth ?? 1, 1) / Math.max(parent?.clientHeight ?? 1, 1);
  }

  private resize(): void {
    const parent = this.canvas.parentElement;
    const width = Math.max(parent?.clientWidth ?? 1, 1);
    const height = Math.max(parent?.clientHeight ?? 1, 1);
    this.renderer?.setSize(width, height, false);
    const aspect = width / height;
    if (this.camera instanceof THREE.PerspectiveCamera) {
      this.camera.aspect = aspect;
    } else {
      this.camera.left = -this.halfHeight * aspect;
      this.camera.right = this.halfHeight * aspect;
      this.camera.top = this.halfHeight;
      this.camera.bottom = -this.halfHeight;
    }
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    for (const material of this.lineMaterials) material.resolution.set(width, height);
    this.draw();
  }

  /** Draws before the next frame. */
  draw(): void {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.drawNow();
    });
  }

  drawNow(): void {
    this.pace();
    this.camera.updateMatrixWorld();
    this.renderer?.render(this.scene, this.camera);
    for (const listener of this.listeners) listener();
  }

  /** Calls back when a moving picture has to be drawn with less, and when it may be drawn whole again. */
  onHurry(listener: (isHurried: boolean) => void): void {
    this.hurry = listener;
  }

  /** Watches how long pictures take while they move. */
  private pace(): void {
    if (!this.hurry) return;
    const now = performance.now();
    const isMoving = now - this.movedAt < PAUSE;
    const interval = now - this.drawnAt;
    this.drawnAt = now;
    // After a pause an interval says nothing.
    if (isMoving && !this.isHurried && interval < 20 * PAUSE) this.slow = interval > SLOW ? this.slow + 1 : 0;
    const wanted = isMoving && this.slow >= 2;
    if (wanted) setTimeout(() => performance.now() - this.movedAt >= PAUSE && this.draw(), PAUSE + 20);
    if (wanted === this.isHurried) return;
    this.isHurried = wanted;
    this.hurry(wanted);
  }

  /** Calls back after each picture. */
  onDraw(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** The picture as a PNG. */
  async png(): Promise<Blob> {
    this.movedAt = -Infinity;
    this.drawNow();
    return new Promise((resolve, reject) => {
      this.canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no picture"))), "image/png");
    });
  }

  /** The ray through a point of the window, in pixels from its upper left corner. */
  ray(x: number, y: number): THREE.Ray {
    const caster = new THREE.Raycaster();
    const place = new THREE.Vector2((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight);
    caster.setFromCamera(place, this.camera);
    return caster.ray;
  }

  /** Where a point is in the window, in pixels from its upper left corner, and how deep. */
  project(point: THREE.Vector3): THREE.Vector3 {
    const at = point.clone().project(this.camera);
    return new THREE.Vector3(
      ((at.x + 1) / 2) * this.canvas.clientWidth,
      ((1 - at.y) / 2) * this.canvas.clientHeight,
      at.z,
    );
  }
}

/** A renderer, or null where there is none: without WebGL, or where it is switched off. */
function rendererOf(canvas: HTMLCanvasElement): THREE.WebGLRenderer | null {
  const attributes = { alpha: true, depth: true, stencil: false, antialias: true, preserveDrawingBuffer: true };
  const context = canvas.getContext("webgl2", attributes) as WebGL2RenderingContext | null;
  return context ? new THREE.WebGLRenderer({ canvas, context, ...attributes }) : null;
}
